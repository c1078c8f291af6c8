using LabRaytracer.Benchmarks;

if (args.Length > 0 && args[0] == "scenes")
{
    return SceneCommand.Run(args[1..]);
}

if (args.Length > 0 && args[0] == "rays")
{
    return RayCommand.Run(args[1..]);
}

if (args.Length > 0 && args[0] == "skipping")
{
    return SkippingCommand.Run(args[1..]);
}

if (args.Length > 0 && args[0] == "frontier")
{
    return FrontierCommand.Run(args[1..]);
}

BenchmarkDotNet.Running.BenchmarkSwitcher.FromAssembly(System.Reflection.Assembly.GetExecutingAssembly()).Run(args);
return 0;
