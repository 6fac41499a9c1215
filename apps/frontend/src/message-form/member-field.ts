import type { FieldDescriptor, JsonValue } from '@ubii/proto';

/** Props of the field for a member, which lists and messages pass to their slot. */
export interface MemberField {
  readonly field: FieldDescriptor;
  readonly json: JsonValue | undefined;
  readonly path: string;
  readonly label?: string;
  readonly onChange: (json: JsonValue | undefined) => void;
}
