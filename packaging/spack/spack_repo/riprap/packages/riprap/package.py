# riprap for Spack, built from the commits of the checkout that this file lies in.
#
#   spack repo add packaging/spack/spack_repo/riprap
#   spack install riprap            for GPUs: riprap +cuda cuda_arch=90
#
# SPDX-License-Identifier: GPL-3.0-or-later
import os

from spack_repo.builtin.build_systems.cuda import CudaPackage
from spack_repo.builtin.build_systems.generic import Package

from spack.package import (Executable, conflicts, depends_on, license, on_package_attributes,
                           run_after, version, working_dir)


class Riprap(Package, CudaPackage):
    """Particle methods for free-surface flow with solids in it, inside OpenFOAM: smoothed particle
    hydrodynamics, particles in cells and discrete elements, on CPUs and NVIDIA GPUs."""

    license("GPL-3.0-or-later", checked_by="riprap developers")

    git = "file://" + os.path.abspath(os.path.join(os.path.dirname(__file__), *[".."]*6))

    version("main", branch="main")
    version("0.1.0", tag="v0.1.0")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("gmake", type="build")
    depends_on("eigen@3:", type="build")

    # v1912, and v2406 to v2512 of openfoam.com, with the sources' headers and wmake
    depends_on("openfoam@1912:1912_999999,2406:2512 +source precision=dp")
    depends_on("python@3.9:", type="run")
    depends_on("py-numpy", type="run")
    depends_on("py-matplotlib", type="run")

    conflicts("%gcc@:8", msg="riprap is C++17")
    conflicts("cuda_arch=none", when="+cuda",
              msg="cuda_arch: 80, 90 or another that the CUDA of the spec knows")
    conflicts("^cuda@:10", when="+cuda", msg="nvcc knows C++17 from 11 on")

    def setup_build_environment(self, env):
        spec = self.spec
        # Spack has installed what is needed, and its compiler wrapper sets the processor
        env.set("RIPRAP_BOOTSTRAP", "no")
        env.set("RIPRAP_CPU_ARCH", "")
        if spec.satisfies("+cuda"):
            env.set("NVCC", spec["cuda"].prefix.bin.nvcc)
            env.set("RIPRAP_CUDA_ARCH", " ".join(spec.variants["cuda_arch"].value))
        else:
            env.set("NVCC", "")

    def install(self, spec, prefix):
        # As many jobs as cores, or WM_NCOMPPROCS
        Executable("./Allwmake")()
        Executable("etc/install")(prefix)

    def setup_run_environment(self, env):
        env.set("RIPRAP_DIR", self.prefix)
        env.set("RIPRAP_PYTHON", os.path.join(self.spec["python"].prefix.bin, "python3"))

    @run_after("install")
    @on_package_attributes(run_tests=True)
    def check_tutorial(self):
        """Mesh and particles of a tutorial, without a run"""
        with working_dir("check", create=True):
            Executable(self.prefix.bin.riprapCase)("sphDem/damBreak3D", "-noRun", "-noPlot")
