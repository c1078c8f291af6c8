namespace LabRaytracer;

/// <summary>A file that a scene names.</summary>
/// <param name="Name">The name in the scene.</param>
/// <param name="FullPath">The absolute path.</param>
/// <param name="Node">Where the scene names it.</param>
internal sealed record SceneFilePath(string Name, string FullPath, SceneNode Node)
{
    private static readonly string[] s_devices = ["con", "prn", "aux", "nul", "conin$", "conout$", "clock$"];

    /// <summary>Why a name is refused; null if it is not. The same on every system, so that a scene that loads here loads everywhere.</summary>
    public static string? Refusal(string name, bool allowOutside)
    {
        if (name.Length == 0)
        {
            return "is empty";
        }

        if (name.Any(char.IsControl))
        {
            return "has a control character";
        }

        if (name.Contains("://", StringComparison.Ordinal))
        {
            return "is an address, not a file";
        }

        string[] steps = name.Split('/', '\\');
        if (steps.Any(IsDevice))
        {
            return "is the name of a device";
        }

        if (allowOutside)
        {
            return null;
        }

        if (name.Contains('\\'))
        {
            return "has a backslash";
        }

        if (Path.IsPathRooted(name) || name[0] is '/' or '~' || name.Contains(':'))
        {
            return "is an absolute path";
        }

        return Leaves(steps) ? "leaves the scene's folder" : null;
    }

    private static bool Leaves(string[] steps)
    {
        int depth = 0;
        foreach (string step in steps)
        {
            depth += step switch { ".." => -1, "." or "" => 0, _ => 1 };
            if (depth < 0)
            {
                return true;
            }
        }

        return false;
    }

    // Windows takes these for devices in any folder and with any extension.
    private static bool IsDevice(string step)
    {
        string stem = step.Split('.', ':')[0].TrimEnd(' ').ToLowerInvariant();
        return s_devices.Contains(stem) || (stem.Length == 4 && stem[..3] is "com" or "lpt" && char.IsDigit(stem[3]));
    }
}
