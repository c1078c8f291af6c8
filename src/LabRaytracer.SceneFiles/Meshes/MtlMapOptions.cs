using System.Text;

namespace LabRaytracer;

/// <summary>The options of a map_ line of an MTL file.</summary>
internal sealed class MtlMapOptions
{
    /// <summary>The options, for messages.</summary>
    public const string Words = "-s u v w, -o u v w, -clamp on|off, -imfchan r|g|b|l|m|z, -blendu, -blendv, -cc on|off, -bm, -boost, -texres number, -mm base gain, -t u v w";

    private double[] _scale = [1, 1, 1];
    private double[] _offset = [0, 0, 0];
    private bool _clamp;

    /// <summary>Options -s, then -o.</summary>
    public UvTransform Transform => new(new TextureCoordinate(_offset[0], _offset[1]), 0, new TextureCoordinate(_scale[0], _scale[1]), new TextureCoordinate(0, 0));

    /// <summary>Option -imfchan; null where it is not there.</summary>
    public TextureChannel? Channel { get; private set; }

    /// <summary>Option -bm: height of a bump map where it is 1, scene units.</summary>
    public double BumpHeight { get; private set; } = 0.02;

    /// <summary>Option -clamp; without it a picture repeats.</summary>
    public SamplingOptions Sampling
    {
        get
        {
            TextureWrap wrap = _clamp ? TextureWrap.Clamp : TextureWrap.Repeat;
            return new SamplingOptions { WrapU = wrap, WrapV = wrap };
        }
    }

    /// <summary>Reads one option with its values; false leaves the line at what is wrong.</summary>
    public bool TryRead(ref LineText line)
    {
        LineText ahead = line;
        string word = Encoding.UTF8.GetString(ahead.Word());
        bool good = word switch
        {
            "-s" => TryNumbers(ref ahead, 1, out _scale),
            "-o" => TryNumbers(ref ahead, 0, out _offset),
            "-t" => TryNumbers(ref ahead, 0, out _),
            "-bm" => TryHeight(ref ahead),
            "-boost" or "-texres" => ahead.TryNumber(out _),
            "-mm" => ahead.TryNumber(out _) && ahead.TryNumber(out _),
            "-clamp" => TrySwitch(ref ahead, out _clamp),
            "-blendu" or "-blendv" or "-cc" => TrySwitch(ref ahead, out _),
            "-imfchan" => TryChannel(ref ahead),
            _ => false,
        };
        line = good ? ahead : line;
        return good;
    }

    // One to three numbers; a file name that starts with a digit is not one of them, unless it is nothing but a number.
    private static bool TryNumbers(ref LineText line, double standard, out double[] numbers)
    {
        numbers = [standard, standard, standard];
        if (!line.TryNumber(out numbers[0]))
        {
            return false;
        }

        for (int i = 1; i < 3 && line.TryNumber(out double number); i++)
        {
            numbers[i] = number;
        }

        return Array.TrueForAll(numbers, number => Math.Abs(number) <= 1e9);
    }

    private bool TryHeight(ref LineText line)
    {
        bool good = line.TryNumber(out double height) && Math.Abs(height) <= 1e6;
        BumpHeight = height;
        return good;
    }

    private static bool TrySwitch(ref LineText line, out bool on)
    {
        string word = Encoding.UTF8.GetString(line.Word());
        on = word == "on";
        return word is "on" or "off";
    }

    private bool TryChannel(ref LineText line)
    {
        string word = Encoding.UTF8.GetString(line.Word());
        Channel = word switch
        {
            "r" => TextureChannel.Red,
            "g" => TextureChannel.Green,
            "b" => TextureChannel.Blue,
            "m" => TextureChannel.Alpha,
            _ => TextureChannel.Luminance,
        };
        return word is "r" or "g" or "b" or "l" or "m" or "z";
    }
}
