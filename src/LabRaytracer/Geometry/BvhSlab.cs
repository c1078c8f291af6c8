namespace LabRaytracer;

/// <summary>One axis of rays on their way through boxes: the planes of a box at coordinate c are met at <c>c * Inverse + Near</c> and <c>c * Inverse + Far</c>.</summary>
/// <typeparam name="F">Float lanes.</typeparam>
internal struct BvhSlab<F>
    where F : unmanaged, IReal<F>
{
    /// <summary>1 / direction.</summary>
    public F Inverse;

    /// <summary>Offset of the plane that is met first, early by the bound of all rounding errors.</summary>
    public F Near;

    /// <summary>Offset of the plane that is met last, late by the same bound.</summary>
    public F Far;
}
