namespace LabRaytracer;

/// <summary>What became of rays that were looked at as a pencil.</summary>
internal enum PencilAnswer
{
    /// <summary>They are none: nothing happened.</summary>
    NoPencil,

    /// <summary>All is found.</summary>
    Found,

    /// <summary>They meet so many triangles that they are better off on their own. What was found so far is kept, and they have to be searched for again within their limits.</summary>
    TooWide,
}
