namespace LabRaytracer;

/// <summary>Where the cells of a checker lie.</summary>
public enum CheckerSpace
{
    /// <summary>In texture space: squares of (u, v).</summary>
    Uv,

    /// <summary>In the object: cubes of the local point (x, y, z).</summary>
    Local,
}
