import { isSameValue, type ModuleExtension, type ProcessingModule } from '@ubii/proto';
import type { InstanceSpec } from '../runtime/module-runtime.ts';

/** Members of its module that an instance applies while it runs, besides its mapping: no restart. [PM-62] */
type LiveField = 'processingMode';

/** Members that no instance depends on: descriptions, and notes of the master about the module. */
type NoteField =
  | 'id'
  | 'nodeId'
  | 'status'
  | 'authors'
  | 'tags'
  | 'description'
  | 'version'
  | 'origin'
  | 'replaceable'
  | 'grantIds';

/**
 * Members of its module that an instance uses once, at its start: another value requires a new instance [SE-15]. New
 * fields of the schema belong here, unless they are listed above.
 */
export type ModuleIdentity = Readonly<
  Omit<ProcessingModule & ModuleExtension, LiveField | NoteField | 'extension'> &
    Pick<InstanceSpec, 'isTrusted'>
>;

/** One of the values that make a module the same. */
export type IdentityField = keyof ModuleIdentity;

/**
 * Returns what makes the module of an instance the same: code, with the language and whether it is trusted; name and
 * session, which its reports and topics have; inputs and outputs; libraries and asset sets. Mapping and processing mode
 * may change while the instance runs. An extension that is left out is an empty one.
 */
export function moduleIdentity({
  module,
  isTrusted,
}: Pick<InstanceSpec, 'module' | 'isTrusted'>): ModuleIdentity {
  const { libraries = [], assets = [], optionalAssets = [] } = module.extension ?? {};
  return {
    name: module.name,
    sessionId: module.sessionId,
    language: module.language,
    onCreatedStringified: module.onCreatedStringified,
    onProcessingStringified: module.onProcessingStringified,
    onHaltedStringified: module.onHaltedStringified,
    onDestroyedStringified: module.onDestroyedStringified,
    inputs: module.inputs,
    outputs: module.outputs,
    libraries,
    assets,
    optionalAssets,
    isTrusted,
  };
}

/** Lists the fields that differ; with one or more, an instance of `before` has to be made again to be one of `after`. */
export function identityChanges(before: ModuleIdentity, after: ModuleIdentity): IdentityField[] {
  const fields = Object.keys(before) as IdentityField[];
  return fields.filter((field) => !isSameValue(before[field], after[field]));
}

/** Whether both have the same callbacks. Says whose code it is, not whether an instance can stay. [PM-51] [PM-64] */
export function hasSameCode(one: ProcessingModule, other: ProcessingModule): boolean {
  return (
    one.onProcessingStringified === other.onProcessingStringified &&
    one.onCreatedStringified === other.onCreatedStringified &&
    one.onHaltedStringified === other.onHaltedStringified &&
    one.onDestroyedStringified === other.onDestroyedStringified
  );
}
