lagrange::system! {
    struct Forms;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    event nothing;
    event without = x;
    event comma = x,;
    event unsaid = x => stop;
    event missing = x falling => stop;
    event misspelt = x, faling => stop;
    event silent = x, falling;
    event arrow = x, falling stop;
    event dash = x, falling -> stop;
    event empty = x, rising =>;
    event explode = x, rising => explode;
    event stopp = x, rising => stpo;
    event bounce = x, falling => impact;
    event rebound = x, falling => impact();
    event pair = x, falling => impact(0, 1);
    event halt = x, falling => stop x;
    event idle = x, falling => {};
    event half = x, falling => { dot(x) };
    event twice = x, falling => { x = 1 y = 2; };
    event wall = x - 3, rising => { const v = 1; dot(x) = -v / 2; }
    event fine = x, falling => record;
}

fn main() {}
