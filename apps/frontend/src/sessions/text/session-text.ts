import {
  DecodeError,
  fromJson,
  toJson,
  type Init,
  type Session,
  type SessionProblem,
} from '@ubii/proto';
import { jsonLines } from './json-lines.ts';

const SESSION = 'ubii.sessions.Session';

/** Problem of a text, with its line. */
export interface TextProblem {
  readonly isError: boolean;
  readonly message: string;
  /** From 1; `undefined` when it concerns the whole text. */
  readonly line: number | undefined;
  /** Path in the session, by the schema; empty for the whole session. */
  readonly path: string;
}

/** A session from a text, or the reason why it is invalid. */
export type ReadSession =
  | {
      readonly kind: 'read';
      readonly session: Session;
      /** Warnings. */
      readonly problems: readonly TextProblem[];
    }
  | { readonly kind: 'broken'; readonly problems: readonly TextProblem[] };

/** Formats a session for reading and editing: indented JSON without empty members. */
export function sessionText(spec: Init<Session>): string {
  return `${JSON.stringify(prune(toJson(SESSION, spec)), undefined, 2)}\n`;
}

/** Parses a session from a text. [SE-6] */
export function readSessionText(text: string): ReadSession {
  const lines = jsonLines(text);
  if (lines.kind === 'broken') {
    const { line, message } = lines;
    return broken({ isError: true, line, message, path: '' });
  }
  const value: unknown = JSON.parse(text);
  if (!isObject(value)) {
    return broken({
      isError: true,
      line: 1,
      path: '',
      message: 'Expected a session as an object: { … }.',
    });
  }
  try {
    const session = fromJson(SESSION, value);
    const problems = unknownMembers(value, session).map((path) => ({
      isError: false,
      path,
      line: lines.lineOf(path),
      message: `${path} is unknown and ignored.`,
    }));
    return { kind: 'read', session, problems };
  } catch (cause) {
    if (!(cause instanceof DecodeError)) throw cause;
    const reason = cause.message.slice(cause.message.indexOf(': ') + 2);
    const path = reason.split(' must be ', 1)[0]!;
    const line = lines.lineOf(path);
    return broken({ isError: true, line, path: '', message: `${reason}.` });
  }
}

/** Assigns the master's problems to lines of the text. */
export function problemsOnLines(text: string, problems: readonly SessionProblem[]): TextProblem[] {
  const lines = jsonLines(text);
  return problems.map(({ isError, message, path }) => ({
    isError,
    message,
    path,
    line: lines.kind === 'read' ? lines.lineOf(path) : undefined,
  }));
}

const broken = (...problems: readonly TextProblem[]): ReadSession => ({ kind: 'broken', problems });

function isObject(value: unknown): value is object {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

/** Members of mappings from old clients, which are accepted. [SE-6] */
const LEGACY_MEMBERS: ReadonlySet<string> = new Set(['topicSource', 'topicDestination']);

/** Paths of members that the schema does not have, mostly misspelt. */
function unknownMembers(value: object, read: object, path = ''): string[] {
  return Object.entries(value).flatMap(([name, member]: [string, unknown]) => {
    const key = name.replace(/_([a-z])/g, (_, letter: string) => letter.toUpperCase());
    const inner = path === '' ? name : `${path}.${name}`;
    if (member === null || LEGACY_MEMBERS.has(key)) return [];
    if (!(key in read)) return [inner];
    return unknownWithin(member, (read as Record<string, unknown>)[key], inner);
  });
}

function unknownWithin(value: unknown, read: unknown, path: string): string[] {
  if (Array.isArray(value) && Array.isArray(read) && value.length === read.length) {
    return value.flatMap((one, index) => unknownWithin(one, read[index], `${path}[${index}]`));
  }
  return isObject(value) && isObject(read) ? unknownMembers(value, read, path) : [];
}

/** Members that only the master writes. */
const MASTERS: ReadonlySet<string> = new Set([
  'status',
  'sessionId',
  'state',
  'problems',
  'revision',
  'stored',
  'replaceable',
]);

/** Removes empty texts and lists, `false`, and members that the master adds. */
function prune(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(prune);
  if (!isObject(value)) return value;
  const kept = Object.entries(value)
    .filter(([name]) => !MASTERS.has(name))
    .map(([name, member]) => [name, prune(member)] as const)
    .filter(([name, member]) => !isNothing(name, member));
  return Object.fromEntries(kept);
}

function isNothing(name: string, value: unknown): boolean {
  if (value === undefined || value === null || value === '' || value === false) return true;
  if (Array.isArray(value)) return value.length === 0;
  if (name === 'lockstepHertz') return value === 0;
  // Other empty objects have a meaning: `{ "free": {} }`.
  return name === 'extension' && isObject(value) && Object.keys(value).length === 0;
}
