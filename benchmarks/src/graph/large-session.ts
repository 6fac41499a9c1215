import { randomUUID } from 'node:crypto';
import type { Init, IOMapping, ProcessingModule, Session } from '@ubii/proto';

/** Modules above each other; as many topics feed the first column. */
const ROWS = 10;
const INPUTS = ['a', 'b'] as const;
/** Distances of nodes, pixels at a zoom of 1. */
const PITCH = { x: 280, y: 140 };
/** Frequency of a module, Hz; 200 modules and their sources publish 1000 records a second. */
const MODULE_HERTZ = 4;
/** Publishing frequency of each source, Hz. */
export const SOURCE_HERTZ = 20;

/** Code of each module: its output changes with every run. */
export const ADDER: Init<ProcessingModule> & { name: string } = {
  name: 'benchmark-adder',
  onProcessingStringified: `(deltaTime, { a, b }, state) => {
    state.run = (state.run || 0) + 1;
    const of = (value) => (value && value.double) || 0;
    return { outputs: { out: { double: ((of(a) + of(b)) % 1000) + state.run } } };
  }`,
  inputs: INPUTS.map((internalName) => ({ internalName, messageFormat: 'double' })),
  outputs: [{ internalName: 'out', messageFormat: 'double' }],
  processingMode: { frequency: { hertz: MODULE_HERTZ } },
};

/** A session of many modules in columns, each wired to two of the column before. */
export interface LargeSession {
  readonly session: Init<Session>;
  /** Topics that feed the first column. */
  readonly sources: readonly string[];
  /** Size of the session's graph. */
  readonly nodeCount: number;
  readonly wireCount: number;
}

/**
 * @param name distinguishes sessions and their topics
 * @param showsTopics what a module puts out has a node of its own
 */
export function largeSession(name: string, modules: number, showsTopics: boolean): LargeSession {
  const topicOf = (index: number): string =>
    index < 0 ? `/${name}/source/${index + ROWS}` : `/${name}/sum/${index}`;
  // A master gives others to modules whose ids are none, and their places would be lost.
  const ids = Array.from({ length: modules }, () => randomUUID());
  /** Nobody reads what the last column puts out: it goes nowhere. */
  const isRead = (index: number): boolean => Math.floor(index / ROWS) < (modules - 1) / ROWS - 1;
  const ioMappings = ids.map((processingModuleId, index): Init<IOMapping> => {
    const row = index % ROWS;
    const read = [index - ROWS, index - row - ROWS + ((row + 1) % ROWS)];
    return {
      processingModuleId,
      processingModuleName: ADDER.name,
      inputMappings: INPUTS.map((inputName, input) => ({
        inputName,
        topic: topicOf(read[input]!),
      })),
      outputMappings: isRead(index) ? [{ outputName: 'out', topic: topicOf(index) }] : [],
    };
  });
  const sources = Array.from({ length: ROWS }, (_, row) => topicOf(row - ROWS));
  const shown = showsTopics ? ids.flatMap((_, i) => (isRead(i) ? [topicOf(i)] : [])) : [];
  const columns = showsTopics ? 2 : 1;
  const nodes = [
    ...sources.map((topic, row) => topicNode(topic, 0, row)),
    ...ids.map((id, i) => nodeAt(`module:${id}`, 1 + columns * Math.floor(i / ROWS), i % ROWS)),
    ...shown.map((topic, i) => topicNode(topic, 2 + columns * Math.floor(i / ROWS), i % ROWS)),
  ];
  const editorJson = JSON.stringify({
    format: 'ubi-interact.graph',
    version: 1,
    nodes: Object.fromEntries(nodes),
    wires: {},
  });
  return {
    session: {
      name,
      processingModules: ids.map((id) => ({ ...ADDER, id })),
      ioMappings,
      extension: { editorJson },
    },
    sources,
    nodeCount: nodes.length,
    wireCount: modules * INPUTS.length + shown.length,
  };
}

const topicNode = (topic: string, column: number, row: number) =>
  nodeAt(`topic:${topic}`, column, row);

function nodeAt(id: string, column: number, row: number) {
  const place = { x: column * PITCH.x, y: row * PITCH.y };
  return [id, { kind: id.slice(0, id.indexOf(':')), ...place }] as const;
}
