using System.Text;

namespace LabRaytracer;

/// <summary>What a line of an OBJ file is about.</summary>
internal enum ObjWord
{
    Nothing,
    Position,
    Uv,
    Normal,
    Face,
    UseMaterial,
    Library,
    Ignored,
    Unknown,
}

/// <summary>The first words of the lines of OBJ files.</summary>
internal static class ObjWords
{
    // What the format knows and a triangle mesh does not need: names, smoothing, points, lines, curves, surfaces, display.
    private static readonly HashSet<string> s_ignored = new(StringComparer.Ordinal)
    {
        "o", "g", "s", "l", "p", "vp", "mg", "deg", "bmat", "step", "cstype", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv", "sp", "end", "con",
        "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "ctech", "stech", "maplib", "usemap", "res", "bzp", "bsp", "cdc", "cdp", "call", "csh",
    };

    /// <summary>Words that mean something here, for messages.</summary>
    public const string Allowed = "v, vt, vn, f, usemtl, mtllib, o, g, s, l, p";

    /// <summary>What a first word means.</summary>
    public static ObjWord KindOf(ReadOnlySpan<byte> word) => word switch
    {
        [] => ObjWord.Nothing,
        [(byte)'v'] => ObjWord.Position,
        [(byte)'v', (byte)'t'] => ObjWord.Uv,
        [(byte)'v', (byte)'n'] => ObjWord.Normal,
        [(byte)'f'] or [(byte)'f', (byte)'o'] => ObjWord.Face,
        _ => Rare(word),
    };

    private static ObjWord Rare(ReadOnlySpan<byte> word)
    {
        if (word.SequenceEqual("usemtl"u8))
        {
            return ObjWord.UseMaterial;
        }

        if (word.SequenceEqual("mtllib"u8))
        {
            return ObjWord.Library;
        }

        return word.Length <= 10 && s_ignored.Contains(Encoding.UTF8.GetString(word)) ? ObjWord.Ignored : ObjWord.Unknown;
    }
}
