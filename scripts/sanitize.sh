#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the core and its tests by Clang under ASan and UBSan and runs the tests in which memory is at stake:
# what reads the files of strangers, and with MYOFACE_LONG_TESTS=1 the rest, too.
set -euo pipefail
cd "$(dirname "$0")/.."
tests=myoface-reader-tests
filter='*'
if [ -n "${MYOFACE_LONG_TESTS:-}" ]; then
  tests=myoface-core-tests
  # Cases, plans, meshes, fit, forces, kernels as well. Long simulations say nothing new here and take ten times as long.
  filter='MeshFile*:ObjReader*:Obj.*:OddFiles*:RichObj*:RoundTrip*:SkinTexture*:Companions*:Writer*:Gltf*:Interchange*:Ply*:*PlyEncodings*:ObjWriter*:MeshWriter*:LandmarkFile*:LandmarkNames*:Weld*:Bvh*:Adjacency*:Geodesic*:Archive*:Deflate*:BadFiles*:Isosurface*:CrossSection*:Examine*:FrameGuess.Says*:CaseFile*:OpenFace*:LandmarkDetection.FindsThoseOfTheAverageHead:ClosedLips.ArePartedFromCornerToCorner:ClosedLips.KeepTheFiles*:Midplane.Of*:SpringForces*:*Response*:FitFace*:DragText*:Setting*:RealFace.Files*:ParallelFor.Runs*:StressKernel*:*Camera*:Forces.*:TotalForces*:Bending*:*Euler*:StableTimeStep*:SmoothWarp*:FitSimilarity*:DepthPart*:Drag.OfWhat*:Contraction.OutOf*:Remesh*:Diffusion*:SplitAlong*:FaceScene*:CoarseMesh*:CoarseLevel*:LevelTransfer*:PackedModel.Has*:PackedModel.Is*:PackedModel.T*:Anderson*:Journal.Of*:Measurement*:ResultComparison*:Weakening*:DistanceField*:Barriers.P*:Barriers.Do*:ImplicitMotion*:SweptVolume*:ShapingText*:FollowingScan*:Elasticity.S*:SimulatedSkin.K*:EquilibriumSolver.Ha*:EquilibriumSolver.Ho*:ProtectedCase*:RecordedPlan.ComesBack*:-CaseFile.AThousand*'
fi
MYOFACE_TARGETS=$tests scripts/build.sh asan
export ASAN_OPTIONS=detect_leaks=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 GTEST_TOTAL_SHARDS=2
halves=()
for half in 0 1; do
  GTEST_SHARD_INDEX=$half build/asan/bin/$tests --gtest_brief=1 --gtest_filter="$filter" &
  halves+=($!)
done
for half in "${halves[@]}"; do
  wait "$half"
done
echo "Sanitized tests are good."
