namespace LabRaytracer.Validation;

/// <summary>The stability sweep on its own: <c>[--seed N] [--long] [--json]</c>; exit code 1 if a bound is broken, 2 if an option is wrong.</summary>
internal static class Program
{
    public static int Main(string[] arguments) => StressCommand.Run(arguments, Console.Out, Console.Error);
}
