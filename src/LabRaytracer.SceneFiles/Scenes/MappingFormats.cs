namespace LabRaytracer;

/// <summary>Mappings of scene files: a word, or an object for those with numbers of their own.</summary>
internal static class MappingFormats
{
    private static readonly ChoiceFormat<IMapping> s_word = new(
        ("rectangular", new RectangularMapping()),
        ("cylindrical", new CylindricalMapping()),
        ("spherical", new SphericalMapping()),
        ("mesh", new MeshMapping()),
        ("disk", new DiskMapping()),
        ("box", new BoxMapping()),
        ("hemispherical", new HemisphericalMapping()),
        ("equalArea", new EqualAreaMapping()),
        ("lightProbe", new LightProbeMapping()),
        ("torus", new TorusMapping()),
        ("cone", new ConeMapping()));

    private static readonly VariantFormat<IMapping> s_object = new(
        "type",
        "A mapping with numbers of its own.",
        [],
        () => MappingObjectFormats.All);

    /// <summary>Any mapping.</summary>
    public static EitherFormat<IMapping> Any { get; } = new(
        $"{s_word.Allowed}, an object {{ \"type\": lightProbe | torus | projector, ... }}", (NodeKind.Text, s_word), (NodeKind.Object, s_object))
    { Name = "mapping" };
}
