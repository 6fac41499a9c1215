import { parseDataFormat, type DataFormat, type JsonObject, type JsonValue } from '@ubii/proto';
import { EDITOR_FORMAT, EDITOR_VERSION } from '../../sessions/text/editor-format.ts';
import type { Point } from './graph.ts';
import type { NodeLook } from './make-node.ts';
import { NOTHING_ASIDE, readAside, type Aside } from './standing/set-aside.ts';

/** Editor data of a node: its appearance, and properties that the session cannot represent. */
export interface NodeRecord extends NodeLook {
  readonly kind: string;
  /** True for topics, muxers and demuxers without wires, which exist only in the editor data. */
  readonly isLoose: boolean;
  readonly topic?: string;
  readonly format?: DataFormat | undefined;
  /** JSON of the message of a muxer or demuxer. */
  readonly message?: JsonObject;
  readonly name?: string;
  readonly json?: string;
  /** Inputs that a constant is wired to: node id and input name. */
  readonly targets?: readonly (readonly [node: string, input: string])[];
  readonly text?: string;
  readonly title?: string;
  readonly color?: string;
}

/** Data of graph editors that is stored in a session. [EX-22] */
export interface EditorData {
  readonly nodes: ReadonlyMap<string, NodeRecord>;
  /** Bend points of wires, by wire id. */
  readonly wires: ReadonlyMap<string, readonly Point[]>;
  /** Bypassed or muted modules. */
  readonly aside: Aside;
  /** Unknown members, unchanged; the whole text if it is of another program. */
  readonly foreign: JsonObject;
}

/** Longest text that is parsed, characters; longer ones are kept unchanged. */
const MAX_TEXT_LENGTH = 8_000_000;

/** Parses the editor data of a session. Keeps damaged or unknown parts; never throws. */
export function parseEditorData(text: string): EditorData {
  const nodes = new Map<string, NodeRecord>();
  const wires = new Map<string, readonly Point[]>();
  const aside = NOTHING_ASIDE;
  if (text === '') return { nodes, wires, aside, foreign: {} };
  const json = readJson(text);
  if (!isObject(json)) return { nodes, wires, aside, foreign: { foreignText: text } };
  const { format, version, ...rest } = json;
  if (format !== EDITOR_FORMAT || version !== EDITOR_VERSION) {
    return { nodes, wires, aside, foreign: { foreignJson: json } };
  }
  const foreign: Record<string, JsonValue> = { ...rest };
  takeEach(foreign, 'nodes', nodes, readNode);
  takeEach(foreign, 'wires', wires, readPoints);
  const read = readAside(foreign.aside);
  // Free the key for own data, and keep the data of the other program.
  if (read === undefined && foreign.aside !== undefined) foreign.foreignAside = foreign.aside;
  delete foreign.aside;
  return { nodes, wires, aside: read ?? aside, foreign };
}

function readJson(text: string): unknown {
  if (text.length > MAX_TEXT_LENGTH) return undefined;
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}

const isObject = (value: unknown): value is Record<string, JsonValue> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** Parsed value of a member, and the rest that was not understood. */
interface Reading<T> {
  readonly value: T | undefined;
  readonly left: JsonValue | undefined;
}

/** Parses the members of a section; members that are not understood stay. */
function takeEach<T>(
  members: Record<string, JsonValue>,
  section: string,
  into: Map<string, T>,
  read: (value: JsonValue) => Reading<T>,
): void {
  const all = members[section];
  if (!isObject(all)) {
    // Free the key for own data, and keep the data of the other program.
    if (all !== undefined) members[section] = { '': { others: all } };
    return;
  }
  const kept: [string, JsonValue][] = [];
  for (const [key, member] of Object.entries(all)) {
    const { value, left } = read(member);
    if (value !== undefined) into.set(key, value);
    if (left !== undefined) kept.push([key, left]);
  }
  if (kept.length > 0) members[section] = Object.fromEntries(kept);
  else delete members[section];
}

const TEXTS = ['frame', 'topic', 'name', 'json', 'text', 'title', 'color'] as const;
const KNOWN: ReadonlySet<string> = new Set<string>([
  ...['kind', 'loose', 'x', 'y', 'width', 'height', 'collapsed', 'format', 'message', 'targets'],
  ...TEXTS,
]);

function readNode(member: JsonValue): Reading<NodeRecord> {
  if (!isObject(member) || typeof member.kind !== 'string') {
    return { value: undefined, left: member };
  }
  const { kind, x, y, width, height, message, format, targets } = member;
  const texts = TEXTS.flatMap((name) => {
    const text = member[name];
    return typeof text === 'string' ? [[name, text] as const] : [];
  });
  const known = typeof format === 'string' ? parseDataFormat(format) : undefined;
  const value: NodeRecord = {
    kind,
    isLoose: member.loose === true,
    position: isNumber(x) && isNumber(y) ? { x, y } : undefined,
    size: isNumber(width) && isNumber(height) ? { width, height } : undefined,
    isCollapsed: member.collapsed === true,
    ...Object.fromEntries(texts),
    ...(known !== undefined && { format: known }),
    ...(isObject(message) && { message }),
    ...(Array.isArray(targets) && { targets: readTargets(targets) }),
  };
  const unknown = Object.entries(member).filter(([name]) => !KNOWN.has(name));
  return { value, left: unknown.length > 0 ? Object.fromEntries(unknown) : undefined };
}

function readTargets(targets: readonly unknown[]): NonNullable<NodeRecord['targets']> {
  return targets.flatMap((target) => {
    const [node, input] = Array.isArray(target) ? (target as readonly unknown[]) : [];
    return typeof node === 'string' && typeof input === 'string' ? [[node, input] as const] : [];
  });
}

function readPoints(member: JsonValue): Reading<readonly Point[]> {
  const points = Array.isArray(member) ? member.map(readPoint) : [undefined];
  const isRead = points.every((point) => point !== undefined);
  return isRead ? { value: points, left: undefined } : { value: undefined, left: member };
}

function readPoint(value: unknown): Point | undefined {
  const [x, y] = Array.isArray(value) ? (value as readonly unknown[]) : [];
  return isNumber(x) && isNumber(y) ? { x, y } : undefined;
}

const isNumber = (value: unknown): value is number =>
  typeof value === 'number' && Number.isFinite(value);
