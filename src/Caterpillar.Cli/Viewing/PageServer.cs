namespace Caterpillar.Cli;

/// <summary>Serves one page on this machine only. Open pages poll its version once a second, and reload it after a change.</summary>
internal sealed class PageServer : IDisposable
{
    private readonly HttpListener _listener = new();
    private volatile byte[] _page = [];
    private volatile string _version = "0";

    /// <exception cref="HttpListenerException">The port is in use.</exception>
    public PageServer(int port)
    {
        Address = $"http://localhost:{port}/";
        _listener.Prefixes.Add(Address);
        _listener.Prefixes.Add($"http://127.0.0.1:{port}/");
        _listener.Start();
    }

    public string Address { get; }

    /// <summary>Replaces the page.</summary>
    public void Show(byte[] page)
    {
        var version = Guid.NewGuid().ToString("N");
        var reload = EmbeddedText.Read("usage/reload.html", typeof(PageServer)).Replace("{0}", version, StringComparison.Ordinal);
        _page = [.. page, .. Encoding.UTF8.GetBytes(reload)];
        _version = version;
    }

    /// <summary>Answers until canceled.</summary>
    public async Task Run(CancellationToken cancel)
    {
        using var stop = cancel.Register(_listener.Stop);
        while (!cancel.IsCancellationRequested)
        {
            try
            {
                Answer(await _listener.GetContextAsync());
            }
            catch (Exception closed) when (closed is HttpListenerException or ObjectDisposedException or IOException)
            {
                // The browser has gone, or the server stops.
            }
        }
    }

    private void Answer(HttpListenerContext context)
    {
        var (type, bytes) = context.Request.Url?.AbsolutePath switch
        {
            "/" => ("text/html; charset=utf-8", _page),
            "/version" => ("text/plain", Encoding.UTF8.GetBytes(_version)),
            _ => ("text/plain", (byte[]?)null),
        };
        using var response = context.Response;
        response.StatusCode = bytes is null ? 404 : 200;
        response.ContentType = type;
        response.Headers["Cache-Control"] = "no-store";
        if (bytes is not null) response.OutputStream.Write(bytes);
    }

    public void Dispose() => ((IDisposable)_listener).Dispose();
}
