namespace LabRaytracer;

/// <summary>A material of an MTL file while its lines are read.</summary>
/// <param name="name">Its name.</param>
/// <param name="offset">Where it starts in the file.</param>
internal sealed class MtlDraft(string name, int offset)
{
    public int Offset => offset;

    /// <summary>Kd, Ks, Ka, Ke, Tf by word.</summary>
    public Dictionary<string, Intensity> Colors { get; } = new(StringComparer.Ordinal);

    /// <summary>map_Kd and so on by word.</summary>
    public Dictionary<string, MtlMap> Maps { get; } = new(StringComparer.Ordinal);

    /// <summary>Ns: specular exponent.</summary>
    public double Shininess { get; set; } = 50;

    /// <summary>d: 1 is opaque.</summary>
    public double Opacity { get; set; } = 1;

    /// <summary>Ni: index of refraction.</summary>
    public double IndexOfRefraction { get; set; } = 1;

    /// <summary>illum: 0 to 10, -1 where the file does not say.</summary>
    public int Illumination { get; set; } = -1;

    /// <summary>The material.</summary>
    /// <remarks>
    /// illum 0 shows the diffuse colour without light, 1 has no highlight, 3 to 7 mirror with Ks, 5 and 7 by the angle; with 4, 6, 7 and 9, which are glass, the
    /// transparency is (1 - d) Tf, otherwise d and map_d are the opacity. bump is the height -bm, 0.02 scene
    /// units if that is not given. map_d reads luminance, but alpha where it is the picture of map_Kd.
    /// </remarks>
    public Material Build()
    {
        TextureSlot diffuse = Slot("Kd", Intensity.White);
        bool isGlass = Illumination is 4 or 6 or 7 or 9;
        bool mirrors = Illumination is >= 3 and <= 7;
        return new Material
        {
            Name = name,
            Ambient = Colors.ContainsKey("Ka") || Maps.ContainsKey("map_Ka") ? Slot("Ka", Intensity.White) : null,
            Diffuse = Illumination == 0 ? Intensity.Black : diffuse,
            Specular = Illumination is 0 or 1 ? Intensity.Black : Slot("Ks", Intensity.Black),
            Shininess = Number("map_Ns", Shininess),
            Reflection = mirrors ? Slot("Ks", Intensity.Black) : Intensity.Black,
            Transparency = isGlass ? Colors.GetValueOrDefault("Tf", Intensity.White) * (float)(1 - Opacity) : Intensity.Black,
            Opacity = Number("map_d", isGlass ? 1 : Opacity),
            IndexOfRefraction = IndexOfRefraction,
            Fresnel = Illumination is 5 or 7 ? FresnelModel.Dielectric : FresnelModel.None,
            Bump = Maps.TryGetValue("bump", out MtlMap? bump) ? Number("bump", bump.BumpHeight) : null,
            NormalMap = Maps.TryGetValue("norm", out MtlMap? normals) ? new NormalMap(normals.Texture) { Transform = normals.Transform } : null,
            Emission = Illumination == 0 ? diffuse : Slot("Ke", Intensity.Black),
        };
    }

    // A map without a coefficient shows as it is; a coefficient of 0 with a map is black, as the format has it: they are multiplied.
    private TextureSlot Slot(string word, Intensity standard) => Maps.TryGetValue("map_" + word, out MtlMap? map)
        ? new TextureSlot { Value = Colors.GetValueOrDefault(word, Intensity.White), Texture = map.Texture, Transform = map.Transform }
        : Colors.GetValueOrDefault(word, standard);

    private ScalarSlot Number(string word, double value) => Maps.TryGetValue(word, out MtlMap? map)
        ? new ScalarSlot { Value = (float)value, Texture = map.Texture, Transform = map.Transform, Channel = map.Channel ?? StandardChannel(word, map) }
        : value;

    private TextureChannel StandardChannel(string word, MtlMap map) =>
        word == "map_d" && Maps.TryGetValue("map_Kd", out MtlMap? diffuse) && diffuse.Texture.Path == map.Texture.Path ? TextureChannel.Alpha : TextureChannel.Luminance;
}

/// <summary>A picture of an MTL file.</summary>
/// <param name="Texture">The picture.</param>
/// <param name="Transform">Options -s and -o.</param>
/// <param name="Channel">Option -imfchan; null where it is not there.</param>
internal sealed record MtlMap(Texture Texture, UvTransform Transform, TextureChannel? Channel)
{
    /// <summary>Option -bm, for bump maps: height where the picture is 1, scene units.</summary>
    public double BumpHeight { get; init; }
}
