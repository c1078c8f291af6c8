namespace LabRaytracer;

/// <summary>Lamps of scene files.</summary>
internal static class LightFormats
{
    private static readonly Key<Intensity> s_intensity = Key.Optional("intensity", Colors.Any, Intensity.White, "Linear intensity.");

    private static readonly Key<Point3D> s_position = Key.Required("position", Coordinates.Point, "Position, world space.");

    private static readonly Key<Vector3D> s_direction = Key.Required("direction", Coordinates.Direction, "Direction in which the light travels, world space.");

    private static readonly Key<Point3D> s_target = Key.Required("target", Coordinates.Point, "The point that the axis of the cone goes through, world space.");

    private static readonly Key<double> s_outer = Key.Optional(
        "outerDegrees", new NumberFormat { Above = 0, Max = 90 }, 30, "Angle between the axis and the edge of the cone, degrees.");

    private static readonly Key<double> s_inner = Key.Optional(
        "innerDegrees", new NumberFormat { Min = 0, Max = 90 }, "Angle between the axis and the edge of full light, degrees, not above outerDegrees. Default: the same as outerDegrees.");

    private static readonly Key<Fading> s_attenuation = Key.Optional(
        "attenuation",
        new NumbersFormat<Fading>(
            3,
            "three numbers [constant, linear, quadratic] of at least 0, not all 0",
            n => n.All(factor => factor == 0) ? null : new Fading(n[0], n[1], n[2]),
            fading => [fading.Constant, fading.Linear, fading.Quadratic])
        { Item = NumberFormat.NotNegative },
        new Fading(1, 0, 0),
        "Fading with distance d: 1 / (constant + linear d + quadratic d^2).");

    private static readonly Key<Intensity> s_radiance = Key.Optional(
        "radiance", Colors.Any, Intensity.White, "Linear radiance: the brightness of the lamp as a camera sees it.");

    private static readonly Key<Point3D> s_corner = Key.Required("corner", Coordinates.Point, "A corner, world space.");

    private static readonly Key<Vector3D> s_edgeU = Key.Required("edgeU", Coordinates.Direction, "Edge from the corner, scene units; the lamp faces edgeU x edgeV, as a quad does.");

    private static readonly Key<Vector3D> s_edgeV = Key.Required("edgeV", Coordinates.Direction, "Other edge from the corner, scene units; not along edgeU.");

    private static readonly Key<int> s_samples = Key.Optional(
        "samples", new IntegerFormat(1, QuadLight.MaxSamples), 16, "Samples at each point; powers of two are best, 1 is the middle of the lamp with hard shadows.");

    private static readonly Key<LightSides> s_sides = Key.Optional("sides", ChoiceFormat.Of<LightSides>(), LightSides.Front, "Sides that shine.");

    private static readonly Key<bool> s_visible = Key.Optional("visible", SwitchFormat.Instance, false, "Whether rays see the lamp.");

    private static readonly Key<TextureSlot> s_sky = Key.Optional(
        "radiance", SlotFormats.Color, "Linear radiance by direction, as of the background. Default: the scene's background, turned as it is.");

    private static readonly Key<Transform> s_rotation = Key.Optional("rotation", TransformFormats.Any, "Turns the surroundings: steps with rotateDegrees. Default: none.");

    private static readonly Key<int> s_skySamples = Key.Optional(
        "samples", new IntegerFormat(1, QuadLight.MaxSamples), 32, "Samples at each point; powers of two are best. A constant colour needs none.");

    /// <summary>A lamp, told by its type.</summary>
    public static VariantFormat<Light> Any { get; } = new(
        "type",
        "A lamp.",
        [
            new("pointLight", "Light from a point in all directions.", [s_position, s_intensity, s_attenuation], Point, ("type", "point")),
            new("directionalLight", "Parallel light from far away, such as the sun.", [s_direction, s_intensity], Directional, ("type", "directional")),
            new("spotLight", "A cone of light.", [s_position, s_target, s_intensity, s_outer, s_inner, s_attenuation], Spot, ("type", "spot")),
            new("quadLight", "A flat lamp with soft shadows.", [s_corner, s_edgeU, s_edgeV, s_radiance, s_samples, s_sides, s_visible], FlatLamp, ("type", "quad")),
            new("environmentLight", "Light from all around: every direction has the radiance of a texture.", [s_sky, s_rotation, s_skySamples], Surroundings, ("type", "environment")),
            new("ambientLight", "Light from everywhere, the same at every point.", [s_intensity], fields => new AmbientLight(fields.Get(s_intensity)), ("type", "ambient")),
        ]);

    private static PointLight Point(Fields fields) =>
        new(fields.Get(s_position), fields.Get(s_intensity)) { Attenuation = fields.Get(s_attenuation).Make() };

    private static DirectionalLight Directional(Fields fields) => new(fields.Get(s_direction), fields.Get(s_intensity));

    private static QuadLight? FlatLamp(Fields fields) => fields.Make(
        s_edgeU,
        () => new QuadLight(fields.Get(s_corner), fields.Get(s_edgeV), fields.Get(s_edgeU), fields.Get(s_radiance))
        {
            Samples = fields.Get(s_samples), Sides = fields.Get(s_sides), IsVisible = fields.Get(s_visible),
        },
        "the edges span no area",
        "edges that are not parallel");

    private static EnvironmentLight? Surroundings(Fields fields)
    {
        Transform turned = fields.Has(s_sky) ? Transform.Identity : fields.Reading.BackgroundRotation;
        return fields.Make(
            s_rotation,
            () => new EnvironmentLight(fields.Find(s_sky) ?? fields.Reading.Background)
            {
                Rotation = fields.Find(s_rotation) ?? turned, Samples = fields.Get(s_skySamples),
            },
            TransformFormats.MoreThanRotation,
            TransformFormats.Rotations);
    }

    private static SpotLight? Spot(Fields fields)
    {
        double outer = fields.Get(s_outer), inner = fields.Has(s_inner) ? fields.Get(s_inner) : outer;
        if (inner > outer)
        {
            fields.Fail(s_inner, "the inner angle is larger than the outer", "angles up to outerDegrees");
            return null;
        }

        if (fields.Get(s_position) == fields.Get(s_target))
        {
            fields.Fail(s_target, "the target is where the light stands", "any other point");
            return null;
        }

        return new SpotLight(fields.Get(s_position), fields.Get(s_target), fields.Get(s_intensity), outer, inner)
        {
            Attenuation = fields.Get(s_attenuation).Make(),
        };
    }

    private readonly record struct Fading(double Constant, double Linear, double Quadratic)
    {
        public Attenuation Make() => new(Constant, Linear, Quadratic);
    }
}
