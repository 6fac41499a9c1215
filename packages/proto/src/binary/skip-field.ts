import { MalformedError } from './malformed-error.ts';
import type { Reader } from './reader.ts';

/** Deepest nesting of groups in unknown fields: the limit of other protobuf implementations. */
const MAX_GROUP_DEPTH = 100;

/**
 * Steps over a field that the schema does not have, or has with another wire type.
 *
 * @param tag the field's, already read
 * @throws MalformedError when the field is not well-formed
 */
export function skipField(reader: Reader, tag: number): void {
  skipNested(reader, tag, 0);
}

function skipNested(reader: Reader, tag: number, depth: number): void {
  if (tag >>> 3 === 0) throw new MalformedError(`field number 0 before byte ${reader.pos}`);
  switch (tag & 7) {
    case 0:
      return reader.skipVarint();
    case 1:
      return reader.skip(8);
    case 2:
      return reader.skip(reader.length());
    case 3:
      return skipGroup(reader, tag >>> 3, depth + 1);
    case 5:
      return reader.skip(4);
    default:
      throw new MalformedError(
        `wire type ${tag & 7} of field ${tag >>> 3} before byte ${reader.pos}`,
      );
  }
}

/** Groups are older than proto3 and in no schema of ours, but they are part of the wire format. */
function skipGroup(reader: Reader, field: number, depth: number): void {
  if (depth > MAX_GROUP_DEPTH) {
    throw new MalformedError(`groups nest deeper than ${MAX_GROUP_DEPTH} at byte ${reader.pos}`);
  }
  for (;;) {
    const tag = reader.tag();
    if ((tag & 7) === 4) {
      if (tag >>> 3 === field) return;
      throw new MalformedError(`group ${field} ends as group ${tag >>> 3} at byte ${reader.pos}`);
    }
    skipNested(reader, tag, depth);
  }
}
