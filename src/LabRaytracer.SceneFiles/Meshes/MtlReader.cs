using System.Globalization;
using System.Text;

namespace LabRaytracer;

/// <summary>Reads an MTL file.</summary>
/// <param name="source">The file.</param>
/// <param name="from">Its folder, absolute.</param>
/// <param name="folder">The folder that files must not lie outside of.</param>
/// <param name="places">Where the places of materials and textures are noted.</param>
internal sealed class MtlReader(SceneSource source, string from, SceneFolder folder, SceneSourceMap places)
{
    private const string Words = "newmtl, Kd, Ks, Ka, Ke, Tf, Ns, d, Tr, Ni, illum, map_Kd, map_Ks, map_Ka, map_Ke, map_Ns, map_d, map_bump, bump, norm";

    // What materials here have no coefficient for.
    private static readonly HashSet<string> s_ignored = new(StringComparer.Ordinal)
    {
        "disp", "decal", "refl", "map_Tr", "map_Pr", "map_Pm", "map_Ps", "map_refl", "map_opacity", "map_aat", "map_Disp",
        "Pr", "Pm", "Ps", "Pc", "Pcr", "aniso", "anisor", "sharpness", "Km", "map_Ni", "map_Tf", "map_RMA", "map_ORM",
    };

    private readonly List<MtlDraft> _drafts = [];

    public List<SceneFileError> Mistakes { get; } = [];

    /// <summary>The materials in the order of the file.</summary>
    public IReadOnlyList<Material> Read()
    {
        for (int at = source.TextStart; at < source.Bytes.Length;)
        {
            LineText line = new(source.Bytes, at);
            at = line.Next;
            line.ToWord();
            int first = line.Position;
            string word = Encoding.UTF8.GetString(line.Word());
            if (word == "newmtl")
            {
                StartMaterial(ref line, first);
            }
            else if (word.Length > 0 && !s_ignored.Contains(word))
            {
                ReadLine(word, ref line, first);
            }
        }

        return [.. _drafts.Select(Build)];
    }

    private Material Build(MtlDraft draft)
    {
        Material material = draft.Build();
        places.Note(material, source, draft.Offset);
        return material;
    }

    private void StartMaterial(ref LineText line, int first)
    {
        string name = Encoding.UTF8.GetString(line.Rest());
        if (name.Length == 0)
        {
            Mistake(first, "the material has no name", "newmtl with a name");
        }

        _drafts.Add(new MtlDraft(name, first));
    }

    private void ReadLine(string word, ref LineText line, int first)
    {
        if (_drafts.Count == 0)
        {
            Mistake(first, $"{Wording.Quote(word)} before the first material", "newmtl with a name");
            _drafts.Add(new MtlDraft("", first));
        }

        MtlDraft draft = _drafts[^1];
        switch (word)
        {
            case "Kd" or "Ks" or "Ka" or "Ke" or "Tf":
                ReadColor(word, ref line, draft);
                break;
            case "Ns":
                draft.Shininess = ReadNumber(ref line, 0, 1e6);
                break;
            case "d":
                SkipWord(ref line, "-halo");
                draft.Opacity = ReadNumber(ref line, 0, 1);
                break;
            case "Tr":
                draft.Opacity = 1 - ReadNumber(ref line, 0, 1);
                break;
            case "Ni":
                draft.IndexOfRefraction = ReadNumber(ref line, 0.01, 100);
                break;
            case "illum":
                draft.Illumination = (int)ReadNumber(ref line, 0, 10);
                break;
            case "map_Kd" or "map_Ks" or "map_Ka" or "map_Ke" or "map_Ns" or "map_d":
                ReadMap(word, ref line, draft);
                break;
            case "map_bump" or "map_Bump" or "bump":
                ReadMap("bump", ref line, draft);
                break;
            case "norm" or "map_norm" or "map_Norm":
                ReadMap("norm", ref line, draft);
                break;
            default:
                Mistake(first, $"unknown word {Wording.Quote(word)}{Wording.Suggestion(word, Words.Split(", "))}", Words);
                break;
        }
    }

    private void ReadColor(string word, ref LineText line, MtlDraft draft)
    {
        bool good = line.TryNumber(out double r);
        double g = r, b = r;
        if (good && line.ToWord())
        {
            good = line.TryNumber(out g) && line.TryNumber(out b);
        }

        if (!good || !(Math.Min(r, Math.Min(g, b)) >= 0 && Math.Max(r, Math.Max(g, b)) <= 1e9))
        {
            Mistake(ref line, "one or three numbers of at least 0");
            return;
        }

        draft.Colors[word] = new Intensity((float)r, (float)g, (float)b);
    }

    private double ReadNumber(ref LineText line, double min, double max)
    {
        line.ToWord();
        LineText before = line;
        if (line.TryNumber(out double value) && value >= min && value <= max)
        {
            return value;
        }

        Mistake(ref before, string.Create(CultureInfo.InvariantCulture, $"a number from {min} to {max}"));
        return max;
    }

    private void ReadMap(string word, ref LineText line, MtlDraft draft)
    {
        MtlMapOptions options = new();
        while (line.ToWord() && source.Bytes[line.Position] == '-')
        {
            if (!options.TryRead(ref line))
            {
                Mistake(ref line, MtlMapOptions.Words);
                return;
            }
        }

        int at = line.Position;
        string name = Encoding.UTF8.GetString(line.Rest());
        if (folder.Find(MtlLibrary.Portable(name), from, out string path, isPicture: true) is { } why)
        {
            Mistakes.Add(new SceneFileError(source.Locate(at), why, "the path of a picture, relative to the folder of this file"));
            return;
        }

        Texture texture = folder.Open(path, () => source.Locate(at)).With(options.Sampling);
        places.Note(texture, source, at);
        draft.Maps[word] = new MtlMap(texture, options.Transform, options.Channel) { BumpHeight = options.BumpHeight };
    }

    private static void SkipWord(ref LineText line, string word)
    {
        LineText ahead = line;
        if (Encoding.UTF8.GetString(ahead.Word()) == word)
        {
            line = ahead;
        }
    }

    private void Mistake(ref LineText line, string allowed)
    {
        line.ToWord();
        Mistake(line.Position, line.Describe(), allowed);
    }

    private void Mistake(int offset, string what, string allowed) => Mistakes.Add(new SceneFileError(source.Locate(offset), what, allowed));
}
