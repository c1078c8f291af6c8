using System.Buffers.Binary;
using System.Globalization;
using System.Text;

namespace LabRaytracer;

/// <summary>What the chunks of a PNG file say about the meaning of its samples, and which of them wins.</summary>
internal sealed class PngColorInfo
{
    private TransferFunction? coding;
    private string? codingNote;
    private bool hasSrgb;
    private string? profileName;
    private uint gamma;
    private bool hasOtherPrimaries;

    /// <summary>Whether the chunk is one of those kept here.</summary>
    public static bool Keeps(string type) => type is "cICP" or "sRGB" or "iCCP" or "gAMA" or "cHRM";

    /// <summary>Takes the content of a chunk; false if its length is wrong.</summary>
    public bool Add(string type, ReadOnlySpan<byte> content)
    {
        switch (type)
        {
            case "cICP" when content.Length == 4:
                AddCoding(content[1]);
                return true;
            case "sRGB" when content.Length == 1:
                hasSrgb = true;
                return true;
            case "gAMA" when content.Length == 4:
                gamma = BinaryPrimitives.ReadUInt32BigEndian(content);
                return true;
            case "cHRM" when content.Length == 32:
                AddPrimaries(content);
                return true;
            case "iCCP":
                int end = content.IndexOf((byte)0);
                profileName = end is >= 1 and <= 79 ? Printable(Encoding.Latin1.GetString(content[..end])) : null;
                return end is >= 1 and <= 79;
            default:
                return false;
        }
    }

    /// <summary>The winner: cICP, then sRGB, then gAMA, then a profile's name, then the assumption of sRGB.</summary>
    public (TransferFunction Transfer, string Source) Resolve()
    {
        if (coding is { } known)
        {
            return (known, "cICP chunk");
        }

        if (hasSrgb)
        {
            return (TransferFunction.Srgb, "sRGB chunk");
        }

        string primaries = hasOtherPrimaries ? "; the cHRM chunk's primaries are not those of sRGB and not converted" : "";
        if (FromGamma() is { } power)
        {
            return (power, $"gAMA chunk{primaries}");
        }

        if (profileName is not null)
        {
            return profileName.Contains("sRGB", StringComparison.OrdinalIgnoreCase)
                ? (TransferFunction.Srgb, $"iCCP profile '{profileName}'")
                : (TransferFunction.Srgb, $"assumed; the iCCP profile '{profileName}' is not interpreted");
        }

        return (TransferFunction.Srgb, (codingNote ?? "assumed") + primaries);
    }

    /// <summary>White point and primaries of sRGB are 0.3127, 0.329, 0.64, 0.33, 0.3, 0.6, 0.15, 0.06; files round them.</summary>
    private void AddPrimaries(ReadOnlySpan<byte> content)
    {
        ReadOnlySpan<int> own = [31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000];
        for (int i = 0; i < own.Length; i++)
        {
            hasOtherPrimaries |= Math.Abs((long)BinaryPrimitives.ReadUInt32BigEndian(content[(4 * i)..]) - own[i]) > 100;
        }
    }

    private TransferFunction? FromGamma()
    {
        double exponent = gamma == 0 ? double.NaN : 100000.0 / gamma;
        return exponent switch
        {
            1 => TransferFunction.Linear,
            >= TransferFunction.MinExponent and <= TransferFunction.MaxExponent => TransferFunction.Gamma(exponent),
            _ => null,
        };
    }

    /// <summary>Transfer characteristics of ITU-T H.273, table 3, as far as they are powers or sRGB.</summary>
    private void AddCoding(byte characteristics)
    {
        coding = characteristics switch
        {
            4 => TransferFunction.Gamma(2.2),
            5 => TransferFunction.Gamma(2.8),
            8 => TransferFunction.Linear,
            13 => TransferFunction.Srgb,
            _ => null,
        };
        codingNote = string.Create(CultureInfo.InvariantCulture, $"assumed; the transfer function {characteristics} of the cICP chunk is not known");
    }

    private static string Printable(string text) => string.Concat(text.Select(c => char.IsControl(c) ? '?' : c));
}
