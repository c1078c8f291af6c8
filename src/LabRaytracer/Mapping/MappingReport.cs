namespace LabRaytracer;

/// <summary>What a mapping does to the unit sphere: faults with the first point that shows them, and facts worth knowing.</summary>
/// <param name="Faults">One line a fault: property, what was found, where; empty for a mapping that can be used.</param>
/// <param name="Facts">One line a fact: seams, poles, orientation, dependence on the distance from the origin.</param>
/// <remarks>
/// <para>Checked are: (u, v) finite, also at poles, axes and extreme points; u and v in [0, 1], u below 1 where there is a seam; the same result twice; continuity along great circles,
/// whole turns not counted; one orientation everywhere; the gradient against differences.</para>
/// <para>The points are always the same ones, so a report can be repeated. Immutable, thread safe.</para>
/// </remarks>
public sealed record MappingReport(IReadOnlyList<string> Faults, IReadOnlyList<string> Facts)
{
    /// <summary>Tells whether no fault was found.</summary>
    public bool IsGood => Faults.Count == 0;

    /// <summary>Checks a mapping on the unit sphere, with the sphere's normals.</summary>
    /// <param name="mapping">The mapping.</param>
    /// <exception cref="ArgumentNullException">There is no mapping.</exception>
    public static MappingReport Check(IMapping mapping)
    {
        ArgumentNullException.ThrowIfNull(mapping);
        MappingInspection inspection = new(mapping);
        inspection.Run();
        return new MappingReport(inspection.Faults, inspection.Facts);
    }

    /// <summary>All lines: faults, then facts.</summary>
    public override string ToString() => string.Join('\n', Faults.Select(fault => "fault: " + fault).Concat(Facts));
}
