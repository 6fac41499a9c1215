import type { Random } from '../random.ts';

type Path = readonly (string | number)[];

const MAX_CHANGES = 4;
const KEYS = [
  '__proto__',
  'constructor',
  'toString',
  'length',
  'id',
  'name',
  'topic',
  '',
  'x'.repeat(300),
];

/** Changes a JSON value by its structure: other types, missing and extra members, depth, numbers, texts. */
export function mutateJson(random: Random, seed: unknown): unknown {
  let value = structuredClone(seed);
  const changes = 1 + random.below(MAX_CHANGES);
  for (let i = 0; i < changes; i++) {
    const path = random.pick(pathsOf(value));
    value = changeAt(random, value, path);
  }
  return value;
}

/** A value that a program expecting another kind may stumble over. */
export function strangeValue(random: Random): unknown {
  const texts = [
    ...[
      '',
      ' ',
      '\u0000',
      '\ud800',
      '🙂'.repeat(200),
      'a'.repeat(5_000),
      '../../etc/passwd',
      '%00',
      '/',
    ],
    ...[
      'NaN',
      'Infinity',
      '1e999',
      '-0',
      '9223372036854775808',
      '\r\nX: y',
      '(a+)+$',
      '[',
      '.*',
      '{{{',
    ],
    ...[
      '<script>',
      '${process}',
      '\u202e',
      'x'.repeat(1_100),
      '/info/session/start',
      'AAAA',
      '====',
      '*',
    ],
  ];
  const numbers = [
    0,
    -0,
    -1,
    1,
    0.5,
    2 ** 31,
    -(2 ** 31) - 1,
    2 ** 53,
    1e308,
    -1e308,
    5e-324,
    4_294_967_296,
  ];
  switch (random.below(8)) {
    case 0:
      return null;
    case 1:
      return random.pick([true, false]);
    case 2:
    case 3:
      return random.pick(numbers);
    case 4:
    case 5:
      return random.pick(texts);
    case 6:
      return random.oneIn(4) ? nested(20 + random.below(400), random.oneIn(2)) : [];
    default:
      return random.oneIn(3) ? [null, {}, [], 1, 'x'] : {};
  }
}

function nested(depth: number, isList: boolean): unknown {
  let value: unknown = 0;
  for (let i = 0; i < depth; i++) value = isList ? [value] : { a: value };
  return value;
}

function pathsOf(value: unknown, path: Path = []): Path[] {
  if (typeof value !== 'object' || value === null) return [path];
  return [path, ...Object.entries(value).flatMap(([key, inner]) => pathsOf(inner, [...path, key]))];
}

function changeAt(random: Random, root: unknown, path: Path): unknown {
  if (path.length === 0) {
    if (typeof root === 'object' && root !== null && !Array.isArray(root) && !random.oneIn(10)) {
      return addTo(random, root as Record<string, unknown>);
    }
    return random.oneIn(3) ? strangeValue(random) : root;
  }
  const parent = path.slice(0, -1).reduce<unknown>((at, key) => member(at, key), root);
  const key = path.at(-1)!;
  const holder = parent as Record<string | number, unknown>;
  switch (random.below(5)) {
    case 0:
      delete holder[key];
      return root;
    case 1:
      if (Array.isArray(parent)) {
        const copies = random.oneIn(10) ? 2_000 : 1 + random.below(5);
        for (let i = 0; i < copies; i++) parent.push(structuredClone(parent[Number(key)]));
        return root;
      }
      addTo(random, holder);
      return root;
    case 2: {
      const old = holder[key];
      if (typeof old === 'string') holder[key] = changedText(random, old);
      else if (typeof old === 'number') holder[key] = old * random.pick([-1, 1e10, 0.001, 0]);
      else holder[key] = [old];
      return root;
    }
    default:
      define(holder, key, strangeValue(random));
      return root;
  }
}

function addTo(random: Random, holder: Record<string, unknown>): unknown {
  define(holder, random.pick(KEYS), strangeValue(random));
  return holder;
}

/** As a property of its own, whatever the key: `__proto__` is to travel in the text. */
function define(holder: object, key: string | number, value: unknown): void {
  Object.defineProperty(holder, key, {
    value,
    enumerable: true,
    configurable: true,
    writable: true,
  });
}

function changedText(random: Random, text: string): string {
  const at = random.below(text.length + 1);
  switch (random.below(4)) {
    case 0:
      return text.slice(0, at);
    case 1:
      return text.slice(0, at) + String.fromCharCode(random.below(0x10000)) + text.slice(at);
    case 2:
      return text.repeat(1 + random.below(40));
    default:
      return text.toUpperCase();
  }
}

function member(value: unknown, key: string | number): unknown {
  return (value as Record<string | number, unknown>)[key];
}
