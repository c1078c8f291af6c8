namespace LabRaytracer;

/// <summary>A ray, or several, against eight boxes.</summary>
internal interface IBvhWideTest
{
    /// <summary>Bits of the boxes that may be met at a parameter of [0, limit], and where they are entered at the earliest.</summary>
    unsafe uint Meet(float* planes, float limit, out Float8 near);
}
