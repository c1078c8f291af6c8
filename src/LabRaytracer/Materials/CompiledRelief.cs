namespace LabRaytracer;

/// <summary>What tilts the normals of a material: heights and a normal map made ready.</summary>
internal sealed class CompiledRelief
{
    private CompiledRelief(Material material, LookupList lookups)
    {
        if (material.Bump is { Texture: { } heights } bump && heights.Needs != TextureNeeds.None)
        {
            Height = bump.Amount * bump.Blend switch
            {
                BlendMode.Multiply => bump.Value,
                BlendMode.Mix => 0.5f,
                _ => 1,
            };
            BumpLookup = Height == 0 ? -1 : lookups.AddSlopes(bump);
            BumpSpace = SlopeSampler.SpaceOf(heights);
            BumpCoordinates = BumpLookup < 0 ? -1 : lookups.Lookups[BumpLookup].Coordinates;
        }

        if (material.NormalMap is { Strength: > 0 } map)
        {
            Map = map;
            MapLookup = lookups.Add(map.Texture, map.Mapping, map.Transform, TextureUse.Data);
            MapCoordinates = lookups.AddCoordinates(map.Mapping, map.Transform);
        }

        bool hasOwn = new[] { BumpCoordinates, MapCoordinates }.Any(set => set >= 0 && lookups.Coordinates[set].Mapping is MeshMapping or not IWideMapping);
        Steps = hasOwn ? StepNeeds.Local | StepNeeds.SurfaceGradient : StepNeeds.Local;
    }

    /// <summary>Number of the lookup of the slopes of heights, or -1.</summary>
    public int BumpLookup { get; } = -1;

    /// <summary>What the slopes are derivatives by.</summary>
    public SlopeSpace BumpSpace { get; }

    /// <summary>Its coordinate set, or -1 where heights are a function of the point.</summary>
    public int BumpCoordinates { get; } = -1;

    /// <summary>Scene units of height where the texture grows by 1.</summary>
    public float Height { get; }

    /// <summary>The normal map, or null.</summary>
    public NormalMap? Map { get; }

    /// <summary>Number of its lookup, or -1.</summary>
    public int MapLookup { get; } = -1;

    /// <summary>Coordinate set whose tangents it is in, or -1.</summary>
    public int MapCoordinates { get; } = -1;

    /// <summary>What must be known of steps on the surface.</summary>
    public StepNeeds Steps { get; }

    /// <summary>The relief of a material; null if it has none.</summary>
    public static CompiledRelief? Of(Material material, LookupList lookups)
    {
        CompiledRelief relief = new(material, lookups);
        return relief.BumpLookup < 0 && relief.MapLookup < 0 ? null : relief;
    }
}
