using System;

namespace Caterpillar.CanvasPictures;

/// <summary>A point of the canvas, in pixels; y grows downwards.</summary>
internal readonly record struct Spot(double X, double Y);

/// <summary>A rectangle of the canvas, in pixels.</summary>
internal readonly record struct Box(double X, double Y, double Width, double Height)
{
    public double Right => X + Width;

    public double Bottom => Y + Height;

    public double MiddleX => X + Width / 2;

    public double MiddleY => Y + Height / 2;

    public bool Meets(Box other) => X < other.Right && other.X < Right && Y < other.Bottom && other.Y < Bottom;

    public bool Holds(Spot spot) => spot.X > X && spot.X < Right && spot.Y > Y && spot.Y < Bottom;

    public Box Grown(double by) => new(X - by, Y - by, Width + 2 * by, Height + 2 * by);

    public Box Moved(double dx, double dy) => new(X + dx, Y + dy, Width, Height);

    public Box With(Box other)
    {
        double x = Math.Min(X, other.X), y = Math.Min(Y, other.Y);
        return new Box(x, y, Math.Max(Right, other.Right) - x, Math.Max(Bottom, other.Bottom) - y);
    }
}
