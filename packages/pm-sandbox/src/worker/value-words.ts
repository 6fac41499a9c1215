import { DATA_FORMATS, isMessageType, messageDescriptor, type DataFormat } from '@ubii/proto';

/** Members named in a sentence; the others are left out. */
const MAX_MEMBERS = 4;

/** Values that cannot leave a module, as marked by QuickJS and as they are in V8. */
export type Unsendable = 'a function' | 'a symbol' | 'a bigint' | 'a promise';

/** Says that a promise was written where its value belongs. */
export const AWAIT_ADVICE = 'Make onProcessing async and write await before the value.';

/** Example of an output of a data format: `{ vector2: { x, y } }`. */
export function exampleOf(format: DataFormat): string {
  const { messageType, isList } = DATA_FORMATS[format];
  if (!isMessageType(messageType)) return `{ ${format}: value }`;
  if (isList) return `{ ${format}: { elements: [ … ] } }`;
  const names = messageDescriptor(messageType).fields.map(({ jsonName }) => jsonName);
  return `{ ${format}: ${shownMembers(names)} }`;
}

/** `{ x, y }` of an object, at most some members. */
export function shownMembers(names: readonly string[]): string {
  const shown = names.slice(0, MAX_MEMBERS).map((name) => name.slice(0, 40));
  if (names.length > MAX_MEMBERS) shown.push('…');
  return `{ ${shown.join(', ')} }`;
}

/** A value in a sentence, never its content: equal mistakes give equal sentences. */
export function kindOf(value: unknown): string {
  if (value === null) return 'null';
  if (value === undefined) return 'undefined';
  if (Array.isArray(value) || ArrayBuffer.isView(value)) return 'an array';
  const unsendable = unsendableKind(value);
  if (unsendable !== undefined) return unsendable;
  if (typeof value !== 'object') return `a bare ${typeof value}`;
  const names = Object.keys(value);
  return names.length === 0 ? 'an empty object' : shownMembers(names);
}

/** Undefined when a value of this kind may leave a module. [PM-56] */
export function unsendableKind(value: unknown): Unsendable | undefined {
  if (typeof value === 'function') return 'a function';
  if (typeof value === 'bigint') return 'a bigint';
  if (isThenable(value)) return 'a promise';
  if (typeof value !== 'symbol') return undefined;
  switch (Symbol.keyFor(value)) {
    case 'function':
      return 'a function';
    case 'bigint':
      return 'a bigint';
    case 'promise':
      return 'a promise';
    default:
      return 'a symbol';
  }
}

/** Whether a value is awaited. */
export function isThenable(value: unknown): value is PromiseLike<unknown> {
  return (
    typeof value === 'object' &&
    value !== null &&
    'then' in value &&
    typeof value.then === 'function'
  );
}
