namespace LabRaytracer.Validation;

/// <summary>What a run measures.</summary>
/// <param name="Seed">Random numbers; the same seed gives the same inputs on every machine.</param>
/// <param name="IsLong">True for the long form: hours instead of seconds.</param>
internal sealed record StressOptions(ulong Seed = StressOptions.DefaultSeed, bool IsLong = false)
{
    /// <summary>The seed of the committed table.</summary>
    public const ulong DefaultSeed = 20240607;

    /// <summary>Number of parts of a sweep, each with random numbers of its own.</summary>
    /// <param name="inLongForm">Parts in the long form; the short form has one.</param>
    public int Parts(int inLongForm) => IsLong ? inLongForm : 1;
}
