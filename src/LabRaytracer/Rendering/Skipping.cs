namespace LabRaytracer;

/// <summary>Whether work that cannot change a picture is left out.</summary>
public enum Skipping
{
    /// <summary>It is left out: the default.</summary>
    On,

    /// <summary>It is done and its result not used: for measuring what skipping saves. Colour pictures only; same bits.</summary>
    Off,
}
