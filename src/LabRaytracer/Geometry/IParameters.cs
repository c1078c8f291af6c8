namespace LabRaytracer;

/// <summary>The numbers that describe the shapes which a group of lanes looks at.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal interface IParameters<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Parameter number <paramref name="k"/> of each lane's shape.</summary>
    R this[int k] { get; }
}
