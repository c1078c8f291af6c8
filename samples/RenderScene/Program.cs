using RenderScene;

using SignalStop stop = new();
int code = App.Run(args, AppConsole.System(), stop.Token);
return stop.ExitCode ?? code;
