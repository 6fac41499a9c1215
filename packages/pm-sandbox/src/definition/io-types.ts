import type { DataFormat, DataFormatValues, Init, Timestamp } from '@ubii/proto';

/** Declaration of an input or output: its data format, alone or with further properties. */
export type IoInit =
  | DataFormat
  | {
      readonly format: DataFormat;
      /** A list of records. */
      readonly list?: boolean;
      /** Of an input: its value while it has no record. [PM-5] */
      readonly default?: unknown;
      /** Meaning of the values with unit and range, for people: one sentence. [PM-6] */
      readonly description?: string;
      /** Of an input for a string: the texts it understands; default: any. [PM-7] */
      readonly choices?: readonly string[];
    };

/** Inputs or outputs by their internal names. */
export type IoInits = Readonly<Record<string, IoInit>>;

type FormatOf<I extends IoInit> = I extends DataFormat
  ? I
  : I extends { readonly format: infer F extends DataFormat }
    ? F
    : never;

/**
 * A record as a module sees it: the value is the member named after the data format, and `type` is
 * that name. [PM-30]
 */
export type ModuleRecord<F extends DataFormat = DataFormat> = F extends DataFormat
  ? {
      topic: string;
      /** When the value was taken, by the publisher's clock. */
      timestamp: Timestamp | undefined;
      clientId: string;
      type: F;
    } & { [K in F]: DataFormatValues[K] }
  : never;

/** An element of a list of records. `identity` is missing when the muxer found none. [PM-40] */
export type ModuleElement<F extends DataFormat = DataFormat> = ModuleRecord<F> & {
  identity?: string;
  /** When the node got it, milliseconds since the Unix epoch, master's clock; missing in lockstep. [PM-49] */
  receivedAtMs?: number;
};

/** Value of an input. */
export type ModuleInput<I extends IoInit> = I extends { readonly list: true }
  ? { elements: ModuleElement<FormatOf<I>>[] }
  : ModuleRecord<FormatOf<I>> | undefined;

/** One value to put out. The node adds topic and, when there is none, timestamp. [PM-32] */
export type ModuleValue<F extends DataFormat> = F extends DataFormat
  ? { readonly [K in F]: Init<DataFormatValues[K]> } & {
      readonly timestamp?: Init<Timestamp> | undefined;
    }
  : never;

/** One element to put out: the parameters make its topic, or the identity does. [PM-45] [PM-46] */
export type ModuleElementValue<F extends DataFormat> = ModuleValue<F> & {
  readonly outputTopicParams?: readonly (string | number)[] | undefined;
  readonly identity?: string | undefined;
};

/** Value of an output; undefined publishes nothing. */
export type ModuleOutput<O extends IoInit> = O extends { readonly list: true }
  ? { readonly elements: readonly ModuleElementValue<FormatOf<O>>[] } | undefined
  : ModuleValue<FormatOf<O>> | undefined;

/** All inputs of a module by name. */
export type ModuleInputs<I extends IoInits> = { [K in keyof I]: ModuleInput<I[K]> };

/** Any of the outputs of a module by name. */
export type ModuleOutputs<O extends IoInits> = { readonly [K in keyof O]?: ModuleOutput<O[K]> };
