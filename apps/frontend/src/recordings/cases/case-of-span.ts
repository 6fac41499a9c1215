import type { PatternCompiler } from '@ubii/patterns';
import {
  fromJson,
  type Component,
  type JsonValue,
  type ProcessingModule,
  type Session,
} from '@ubii/proto';
import {
  devicesInSpan,
  topicsOfProfile,
  type RecordedDevice,
  type RecordedRecord,
  type RecordingReader,
  type RecordsReader,
} from '@ubii/recording';
import { muxPreview } from '../../graph/model/live/mux-preview.ts';
import { recordJson, type CaseRecord, type ModuleCase } from '../../modules/cases/module-case.ts';
import { TimeBase } from '../reading/recording-time-base.ts';
import type { Span } from '../timeline/span.ts';

/** A case is kept as text and run in a page: longer ones are for replays. */
const MAX_RECORDS = 20_000;
/** Share of the larger number, for numbers that were computed elsewhere. */
const TOLERANCE = 1e-6;

/** What inputs and outputs select from. */
export interface RecordedParts {
  readonly topics: RecordsReader['summary']['topics'];
  /** Devices that were registered in the span. */
  readonly devices: readonly RecordedDevice[];
}

/** The topics of the inputs and outputs of a module in a session. */
export interface ModuleTopics {
  readonly inputs: readonly { readonly name: string; readonly topics: readonly string[] }[];
  readonly outputs: readonly { readonly name: string; readonly topics: readonly string[] }[];
  /** Devices of the components that inputs select, with these components alone. */
  readonly devices: readonly RecordedDevice[];
}

/** Devices that were registered at any time in the span. */
export async function devicesOfSpan(
  reader: RecordingReader,
  { fromMs, untilMs }: Span,
): Promise<RecordedDevice[]> {
  const base = new TimeBase(reader.summary.startNs);
  const span = { fromNs: base.toNs(fromMs), untilNs: base.toNs(untilMs) };
  return devicesInSpan(await reader.devices(), span);
}

/** Outputs through demultiplexers have no topics: which they write depends on the values. */
export function moduleTopics(
  { ioMappings }: Session,
  moduleId: string,
  { topics: recorded, devices }: RecordedParts,
  patterns: PatternCompiler,
): ModuleTopics {
  const mapping = ioMappings.find(({ processingModuleId }) => processingModuleId === moduleId);
  const existing = new Set(recorded.map(({ topic }) => topic));
  const ofComponents = new Set<string>();
  const topicsOf = (profile: Component): ReadonlySet<string> => {
    const selected = topicsOfProfile(profile, devices);
    for (const topic of selected) ofComponents.add(topic);
    return new Set(selected);
  };
  const known = recorded.map(({ topic, format, clientId }) => ({
    topic,
    format,
    publisherId: clientId,
  }));
  const here = (topic: string | undefined): string[] =>
    topic !== undefined && existing.has(topic) ? [topic] : [];
  const inputs = (mapping?.inputMappings ?? []).map(({ inputName, topic, topicMux }) => {
    if (topicMux === undefined) return { name: inputName, topics: here(topic) };
    const preview = muxPreview(topicMux, known, patterns, topicsOf);
    const matches = preview.kind === 'matches' ? preview.matches : [];
    const topics = matches.filter(({ fits }) => fits).map((match) => match.topic);
    return { name: inputName, topics: [...new Set(topics)] };
  });
  return {
    inputs,
    outputs: (mapping?.outputMappings ?? []).map(({ outputName, topic }) => ({
      name: outputName,
      topics: here(topic),
    })),
    devices: devices.flatMap((device) => {
      const components = device.components.filter(({ topic }) => ofComponents.has(topic));
      return components.length === 0 ? [] : [{ ...device, components }];
    }),
  };
}

/**
 * Makes a test case of what a module got and gave in a span of a recording.
 *
 * @throws Error with a sentence when the span has too many records
 */
export async function caseOfSpan(
  reader: RecordsReader,
  span: Span,
  session: Session,
  module: ProcessingModule,
  topics: ModuleTopics,
): Promise<ModuleCase> {
  const base = new TimeBase(reader.summary.startNs);
  const inputTopics = topicsIn(topics.inputs);
  const outputTopics = topicsIn(topics.outputs);
  const toCase = ({ topic, clientId, record, logTimeNs }: RecordedRecord): CaseRecord[] => {
    const json = jsonOf(record);
    const atMs = base.toMs(logTimeNs) - span.fromMs;
    return json === undefined ? [] : [{ atMs, topic, publisherId: clientId, record: json }];
  };
  const before = await reader.latestAt(base.toNs(span.fromMs), [...inputTopics]);
  const inputs: CaseRecord[] = [];
  const outputs: CaseRecord[] = [];
  for await (const record of reader.records({
    topics: [...inputTopics, ...outputTopics],
    // What came exactly then is in the values before.
    fromNs: base.toNs(span.fromMs) + 1n,
    untilNs: base.toNs(span.untilMs),
  })) {
    (outputTopics.has(record.topic) ? outputs : inputs).push(...toCase(record));
    if (inputs.length + outputs.length > MAX_RECORDS)
      throw new Error(`The span has more than ${MAX_RECORDS} records of this module.`);
  }
  return {
    name: `${module.name} in ${reader.summary.name}`,
    startMs: base.startMs + span.fromMs,
    durationMs: span.untilMs - span.fromMs,
    tolerance: TOLERANCE,
    module,
    mapping: mappingOf(session, module.id),
    devices: topics.devices,
    before: [...before.values()].flatMap(toCase).map((one) => ({ ...one, atMs: 0 })),
    inputs,
    outputs,
  };
}

const topicsIn = (ios: ModuleTopics['inputs']): Set<string> =>
  new Set(ios.flatMap(({ topics }) => topics));

const mappingOf = ({ ioMappings }: Session, moduleId: string) =>
  ioMappings.find(({ processingModuleId }) => processingModuleId === moduleId) ??
  fromJson('ubii.sessions.IOMapping', {});

/** Undefined for records that cannot be decoded, of other programs. */
function jsonOf(record: Uint8Array): JsonValue | undefined {
  try {
    return recordJson(record);
  } catch {
    return undefined;
  }
}
