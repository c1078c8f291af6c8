using System.Runtime.Intrinsics;

namespace LabRaytracer;

/// <summary>How many floats the processor computes at once.</summary>
internal static class LaneWidth
{
    /// <summary>16, 8, 4, or 1 without vector hardware.</summary>
    public static int Best => Vector512.IsHardwareAccelerated ? 16
        : Vector256.IsHardwareAccelerated ? 8
        : Vector128.IsHardwareAccelerated ? 4
        : 1;
}
