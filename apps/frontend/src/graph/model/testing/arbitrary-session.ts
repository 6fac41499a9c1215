import { fromJson, type Session } from '@ubii/proto';
import fc from 'fast-check';

/** Few values, so that references match. */
const ids = fc.constantFrom('', 'a', 'b', 'c', '6f1c');
const names = fc.constantFrom('', 'mirror', 'smooth', '__proto__', 'näme');
const ios = fc.constantFrom('', 'x', 'y', 'z', 'constructor');
const topics = fc.constantFrom('', '/a', '/b', '/c/d', '/one', '/two', '__proto__');
const formats = fc.constantFrom(
  ...['', 'double', 'int32', 'vector2', 'ubii.dataStructure.Vector3', 'boolean', 'my.own.Format'],
);
const constants = fc.constantFrom('', '', '{"double":1}', '{"bool":false}', 'no JSON', '[1,2]');
const numbers = fc.integer({ min: -1, max: 200 });

const io = fc.record({
  internalName: ios,
  messageFormat: formats,
  isRecordList: fc.boolean(),
});

const mode = fc.oneof(
  fc.constant({}),
  fc.record({ frequency: fc.record({ hertz: numbers }) }),
  fc.record({
    triggerOnInput: fc.record({ minDelayMs: numbers, allInputsNeedUpdate: fc.boolean() }),
  }),
  fc.constant({ lockstep: {} }),
  fc.constant({ free: {} }),
);

const module = fc.record(
  {
    id: ids,
    name: names,
    authors: fc.array(names, { maxLength: 2 }),
    nodeId: ids,
    sessionId: ids,
    status: fc.integer({ min: 0, max: 4 }),
    language: fc.integer({ min: 0, max: 4 }),
    processingMode: mode,
    inputs: fc.array(io, { maxLength: 3 }),
    outputs: fc.array(io, { maxLength: 2 }),
    onProcessingStringified: fc.constantFrom('', '() => ({})'),
    extension: fc.record({ version: names, libraries: fc.array(names, { maxLength: 1 }) }),
  },
  { requiredKeys: [] },
);

const mux = fc.record(
  {
    id: ids,
    name: names,
    dataType: formats,
    topicSelector: fc.constantFrom('', '^/a', '('),
    topicGlob: fc.constantFrom('', '/*/a'),
    component: fc.record({ name: names, tags: fc.array(names, { maxLength: 1 }) }),
    identitySource: fc.integer({ min: 0, max: 4 }),
    identityGroup: numbers,
  },
  { requiredKeys: [] },
);

const demux = fc.record(
  { id: ids, name: names, dataType: formats, outputTopicFormat: fc.constantFrom('', '/{{#0}}/a') },
  { requiredKeys: [] },
);

const inputMapping = fc.oneof(
  fc.record({ inputName: ios, constantJson: constants }),
  fc.record({ inputName: ios, topic: topics, constantJson: constants }),
  fc.record({ inputName: ios, topicMux: mux, constantJson: constants }),
);

const outputMapping = fc.oneof(
  fc.record({ outputName: ios }),
  fc.record({ outputName: ios, topic: topics }),
  fc.record({ outputName: ios, topicDemux: demux }),
);

const mapping = fc.record(
  {
    processingModuleId: ids,
    processingModuleName: names,
    inputMappings: fc.array(inputMapping, { maxLength: 4 }),
    outputMappings: fc.array(outputMapping, { maxLength: 4 }),
  },
  { requiredKeys: [] },
);

const look = fc.record(
  {
    kind: fc.constantFrom('topic', 'module', 'muxer', 'comment', 'frame', 'constant', 'other'),
    x: fc.integer(),
    y: fc.oneof(fc.integer(), fc.constant('far')),
    width: numbers,
    height: numbers,
    collapsed: fc.boolean(),
    loose: fc.boolean(),
    topic: topics,
    json: constants,
    targets: fc.array(fc.tuple(fc.constantFrom('module:a', 'module:b'), ios), { maxLength: 2 }),
    text: names,
    frame: names,
    message: fc.constantFrom({}, { id: 'a' }, { id: 1 }, { tags: {} }),
    others: names,
  },
  { requiredKeys: ['kind'] },
);

const nodeIds = fc.constantFrom(
  ...[
    'topic:/a',
    'topic:/b',
    'module:a',
    'module#0',
    'muxer:a',
    'comment:1',
    'constant:1',
    '__proto__',
  ],
);

/** Editor data of this editor, of another one, or none. */
export const arbitraryEditorJson = fc.oneof(
  fc.constant(''),
  fc.constantFrom('{"litegraph":{"nodes":[]}}', '{', 'null', '[1]', '"text"', '\0'),
  fc
    .record(
      {
        format: fc.constant('ubi-interact.graph'),
        version: fc.constantFrom(1, 1, 1, 2),
        nodes: fc.oneof(fc.dictionary(nodeIds, look), fc.jsonValue()),
        wires: fc.oneof(
          fc.constant({ 'topic:/a out > module:a in:x': [[1, 2]], 'no wire': 'at all' }),
          fc.jsonValue(),
        ),
        aside: fc.oneof(
          fc.jsonValue(),
          fc.record({
            modules: fc.array(
              fc.record({
                standing: fc.constantFrom('bypassed', 'muted'),
                module: module.map((one) => ({ ...one, id: 'aside' })),
                mapping: fc.constantFrom(null, { processingModuleId: 'aside' }),
                moduleIndex: fc.nat(3),
                mappingIndex: fc.nat(3),
              }),
              { maxLength: 2 },
            ),
            detours: fc.constantFrom(
              [],
              [
                {
                  moduleId: 'a',
                  was: { inputName: 'x', topic: '/t' },
                  now: { inputName: 'x', topic: '/a' },
                },
              ],
            ),
          }),
        ),
        theirs: fc.jsonValue(),
      },
      { requiredKeys: ['format', 'version'] },
    )
    .map((value) => JSON.stringify(value)),
  fc.jsonValue().map((value) => JSON.stringify(value)),
);

/** Arbitrary sessions of clients, including incomplete ones of old clients. [SE-6] */
export const arbitrarySession: fc.Arbitrary<Session> = fc
  .record(
    {
      id: ids,
      name: names,
      processingModules: fc.array(module, { maxLength: 4 }),
      ioMappings: fc.array(mapping, { maxLength: 5 }),
      tags: fc.array(names, { maxLength: 2 }),
      description: names,
      authors: fc.array(names, { maxLength: 2 }),
      status: fc.integer({ min: 0, max: 3 }),
      editable: fc.boolean(),
      extension: fc.record(
        {
          state: fc.integer({ min: 0, max: 6 }),
          problems: fc.array(fc.record({ message: names }), { maxLength: 1 }),
          startWithMaster: fc.boolean(),
          lockstepHertz: fc.double({ noNaN: true }),
          editorJson: arbitraryEditorJson,
          revision: numbers,
        },
        { requiredKeys: [] },
      ),
    },
    { requiredKeys: [] },
  )
  .map((json) => fromJson('ubii.sessions.Session', json));
