import { parseDataFormat } from '@ubii/proto';
import { defaultProblem } from '../../draft/io-default.ts';
import type { IoDraft, ModuleDraft } from '../../draft/module-draft.ts';

/** TypeScript declarations visible to every module, in terms of the data formats. [PM-10] to [PM-14] */
const COMMON = `
type DataFormats = import('./data-formats/data-format-values.ts').DataFormatValues;
type DataFormat = keyof DataFormats;
type Timestamp = import('./generated/messages.ts').Timestamp;
type Init<T> = T extends Uint8Array | string | number | boolean
  ? T
  : T extends (infer E)[]
    ? readonly Init<E>[]
    : { readonly [K in keyof T]?: Init<T[K]> | undefined };

/** A record: the value is the member named after its data format. */
type InputRecord<F extends DataFormat> = {
  topic: string;
  /** When the value was taken, by the publisher's clock. */
  timestamp: Timestamp | undefined;
  /** Who published it. */
  clientId: string;
  type: F;
} & { [K in F]: DataFormats[K] };

/** The newest record of each topic a muxer selects. */
interface InputList<F extends DataFormat> {
  elements: (InputRecord<F> & {
    /** Whose it is, when the muxer found out. */
    identity?: string;
    /** When the node got it, milliseconds since the Unix epoch, master's clock; missing in lockstep. */
    receivedAtMs?: number;
  })[];
}

/** One value to put out: the member named after the data format. */
type OutputValue<F extends DataFormat> = { readonly [K in F]: Init<DataFormats[K]> } & {
  readonly timestamp?: Init<Timestamp>;
};

/** Values to put out, each on the topic its parameters or its identity make. */
interface OutputList<F extends DataFormat> {
  readonly elements: readonly (OutputValue<F> & {
    readonly outputTopicParams?: readonly (string | number)[];
    readonly identity?: string;
  })[];
}

/** What the node keeps in the state. */
interface NodeState {
  /** The libraries the module asked for, by name. */
  readonly modules: { readonly [library: string]: any };
  /** Files of the asset sets the module asked for, by name and path. */
  readonly assets: { readonly [set: string]: { readonly [path: string]: Uint8Array } };
  /** When the run began, milliseconds since the Unix epoch, master's clock. */
  readonly masterTimeMs: number;
  /** With the mode trigger on input: inputs that were updated since the run before. */
  readonly inputTriggerNames: readonly string[];
}

/** Lasts as long as the instance. What onCreated puts in has its type here. */
type State = import('./state.js').OwnState & NodeState & { [member: string]: any };

interface Result {
  /** What to put out; a missing output publishes nothing. */
  readonly outputs?: Outputs;
  /** Replaces the state. */
  readonly state?: object;
}

/** Called once, before anything else. */
declare let onCreated: (state: State) => void | Promise<void>;
/**
 * Called when the mode says so.
 * @param deltaTimeMs milliseconds since the previous start of a run, 0 in the first
 */
declare let onProcessing: (
  deltaTimeMs: number,
  inputs: Inputs,
  state: State,
) => Result | void | Promise<Result | void>;
/** Called when the instance pauses or ends. */
declare let onHalted: (state: State) => void | Promise<void>;
/** Called last. */
declare let onDestroyed: (state: State) => void | Promise<void>;

/** Lines go to the log of the session. */
declare const console: {
  log(...values: unknown[]): void;
  info(...values: unknown[]): void;
  warn(...values: unknown[]): void;
  error(...values: unknown[]): void;
  debug(...values: unknown[]): void;
};
`;

function member(io: IoDraft, isOptional: boolean, type: string): string {
  return `  ${JSON.stringify(io.name)}${isOptional ? '?' : ''}: ${type};`;
}

function inputType(io: IoDraft): string {
  const { format, isList, defaultJson } = io;
  const known = parseDataFormat(format);
  if (known === undefined) return isList ? '{ elements: any[] }' : 'any';
  if (isList) return `InputList<'${known}'>`;
  const isFilled = defaultJson !== undefined && defaultProblem(io) === undefined;
  return `InputRecord<'${known}'>${isFilled ? '' : ' | undefined'}`;
}

function outputType({ format, isList }: IoDraft): string {
  const known = parseDataFormat(format);
  if (known === undefined) return isList ? '{ readonly elements: readonly any[] }' : 'any';
  return `${isList ? 'OutputList' : 'OutputValue'}<'${known}'> | undefined`;
}

/** Returns the declarations for the code of a module: its inputs, outputs and state. */
export function moduleDeclarations({
  inputs,
  outputs,
}: Pick<ModuleDraft, 'inputs' | 'outputs'>): string {
  const named = (list: readonly IoDraft[]): IoDraft[] => [
    ...new Map(list.filter(({ name }) => name !== '').map((io) => [io.name, io])).values(),
  ];
  return [
    COMMON.trimStart(),
    '/** The newest value of each input. */',
    'interface Inputs {',
    ...named(inputs).map((io) => member(io, false, inputType(io))),
    '}',
    '/** Values that the callbacks can output. */',
    'interface Outputs {',
    ...named(outputs).map((io) => `  readonly${member(io, true, outputType(io)).slice(1)}`),
    '}',
    '',
  ].join('\n');
}
