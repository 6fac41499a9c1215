import type { Init, IOMapping, ProcessingModule, Session } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { codes, doubler, doubling, SessionWorld, TOPICS } from './session-world.ts';

type Case = readonly [
  what: string,
  session: Init<Session>,
  problem: { readonly code: string; readonly path: string },
];

function withModule(module: Init<ProcessingModule>): Init<Session> {
  return { ...doubling('/in', '/out'), processingModules: [{ ...doubler, ...module }] };
}

function withMapping(mapping: Init<IOMapping>, module: Init<ProcessingModule> = {}): Init<Session> {
  return {
    processingModules: [{ ...doubler, ...module }],
    ioMappings: [{ processingModuleName: 'doubler', ...mapping }],
  };
}

const listIo = { inputs: doubler.inputs, outputs: [{ ...doubler.outputs[0], isRecordList: true }] };
const input = 'ioMappings[0].inputMappings[0]';
const output = 'ioMappings[0].outputMappings[0]';

const CASES: readonly Case[] = [
  [
    'a module without a name',
    { processingModules: [{ ...doubler, name: '' }] },
    { code: 'module_without_name', path: 'processingModules[0].name' },
  ],
  [
    'an unknown module without code',
    { processingModules: [{ name: 'unheard-of' }] },
    { code: 'module_unknown', path: 'processingModules[0]' },
  ],
  [
    'code that does not parse',
    withModule({ onProcessingStringified: '(dt, inputs) => {\n  return } }' }),
    { code: 'syntax', path: 'processingModules[0].onProcessingStringified' },
  ],
  [
    'a callback that does not parse',
    withModule({ onHaltedStringified: '(state) => { const = 1 }' }),
    { code: 'syntax', path: 'processingModules[0].onHaltedStringified' },
  ],
  [
    'callbacks without onProcessing',
    withModule({ onProcessingStringified: '', onCreatedStringified: '() => {}' }),
    { code: 'missing_callback', path: 'processingModules[0].onProcessingStringified' },
  ],
  [
    'two inputs of one name',
    withModule({ inputs: [...doubler.inputs, ...doubler.inputs] }),
    { code: 'name_twice', path: 'processingModules[0].inputs[1].internalName' },
  ],
  [
    'an input without a name',
    withModule({ inputs: [...doubler.inputs, { messageFormat: 'double' }] }),
    { code: 'name_empty', path: 'processingModules[0].inputs[1].internalName' },
  ],
  [
    'a mapping of a module that is not there',
    { ...doubling('/in', '/out'), ioMappings: [{ processingModuleName: 'other' }] },
    { code: 'mapping_without_module', path: 'ioMappings[0]' },
  ],
  [
    'an unknown input name',
    withMapping({ inputMappings: [{ inputName: 'inn', topic: '/in' }] }),
    { code: 'unknown_input', path: `${input}.inputName` },
  ],
  [
    'an unknown output name',
    withMapping({ outputMappings: [{ outputName: 'outt', topic: '/out' }] }),
    { code: 'unknown_output', path: `${output}.outputName` },
  ],
  [
    'an input that is mapped twice',
    withMapping({
      inputMappings: [
        { inputName: 'in', topic: '/a' },
        { inputName: 'in', topic: '/b' },
      ],
    }),
    { code: 'mapped_twice', path: 'ioMappings[0].inputMappings[1]' },
  ],
  [
    'a list output on a plain topic',
    withMapping({ outputMappings: [{ outputName: 'out', topic: '/out' }] }, listIo),
    { code: 'list_unexpected', path: `${output}.topic` },
  ],
  [
    'a single output on a demuxer',
    withMapping(
      {
        outputMappings: [
          { outputName: 'single', topicDemux: { outputTopicFormat: '/out/{{#0}}' } },
        ],
      },
      { outputs: [...listIo.outputs, { internalName: 'single', messageFormat: 'double' }] },
    ),
    { code: 'list_expected', path: `${output}.topicDemux` },
  ],
  [
    'a demuxer format without a placeholder',
    withMapping(
      { outputMappings: [{ outputName: 'out', topicDemux: { outputTopicFormat: '/out' } }] },
      listIo,
    ),
    { code: 'demux_without_placeholder', path: `${output}.topicDemux.outputTopicFormat` },
  ],
  [
    'a muxer whose expression is none',
    withMapping({ inputMappings: [{ inputName: 'in', topicMux: { topicSelector: '(' } }] }),
    { code: 'bad_expression', path: `${input}.topicMux.topicSelector` },
  ],
  [
    'a muxer of another data format',
    withMapping({
      inputMappings: [{ inputName: 'in', topicMux: { topicSelector: '/a', dataType: 'vector2' } }],
    }),
    { code: 'format_mismatch', path: `${input}.topicMux.dataType` },
  ],
  [
    'an output to a topic of the master',
    withMapping({ outputMappings: [{ outputName: 'out', topic: '/info/session/start' }] }),
    { code: 'forbidden_topic', path: `${output}.topic` },
  ],
  [
    'a topic that cannot be one',
    withMapping({ outputMappings: [{ outputName: 'out', topic: '/out\n' }] }),
    { code: 'bad_topic', path: `${output}.topic` },
  ],
  [
    'a constant that is no JSON',
    withMapping({ inputMappings: [{ inputName: 'in', constantJson: '{double:1}' }] }),
    { code: 'bad_constant', path: `${input}.constantJson` },
  ],
  [
    'a constant of another format',
    withMapping({ inputMappings: [{ inputName: 'in', constantJson: '{"string":"1"}' }] }),
    { code: 'bad_constant', path: `${input}.constantJson` },
  ],
  [
    'the id of a node that is none',
    withModule({ nodeId: '00000000-0000-4000-8000-999999999999' }),
    { code: 'unknown_node', path: 'processingModules[0].nodeId' },
  ],
  [
    'modules that trigger each other without delay',
    {
      processingModules: [doubler, { ...doubler, name: 'other' }],
      ioMappings: [
        {
          processingModuleName: 'doubler',
          inputMappings: [{ inputName: 'in', topic: '/a' }],
          outputMappings: [{ outputName: 'out', topic: '/b' }],
        },
        {
          processingModuleName: 'other',
          inputMappings: [{ inputName: 'in', topic: '/b' }],
          outputMappings: [{ outputName: 'out', topic: '/a' }],
        },
      ],
    },
    { code: 'endless_cycle', path: 'ioMappings[0]' },
  ],
  [
    'a module that feeds another one a format it does not take',
    {
      processingModules: [
        doubler,
        { ...doubler, name: 'other', inputs: [{ internalName: 'in', messageFormat: 'vector2' }] },
      ],
      ioMappings: [
        {
          processingModuleName: 'doubler',
          outputMappings: [{ outputName: 'out', topic: '/b' }],
        },
        { processingModuleName: 'other', inputMappings: [{ inputName: 'in', topic: '/b' }] },
      ],
    },
    { code: 'format_mismatch', path: 'ioMappings[1].inputMappings[0].topic' },
  ],
];

describe('a session that cannot be', () => {
  it.each(CASES)(
    'is refused for %s, with the place [SE-3] [SE-4]',
    async (_what, session, problem) => {
      const world = await SessionWorld.create();
      const error = await world.refusal(TOPICS.add, session);
      expect(error.code).toBe('invalid_argument');
      const errors = error.problems.filter(({ isError }) => isError);
      expect(errors).toContainEqual(expect.objectContaining({ ...problem, isError: true }));
      for (const { message } of errors) expect(message).toMatch(/^["A-Z].*[^.]\.?$/s);
      // Nothing was created, nothing else stopped.
      const { sessionList } = await world.master.call({ topic: TOPICS.list });
      expect(sessionList?.elements).toEqual([]);
      expect((await world.ask(TOPICS.start, doubling('/in', '/out'))).id).not.toBe('');
    },
  );

  it('is told everything that is wrong at once [SE-3]', async () => {
    const world = await SessionWorld.create();
    const { problems } = await world.refusal(TOPICS.start, {
      processingModules: [{ ...doubler, onProcessingStringified: '(' }],
      ioMappings: [
        {
          processingModuleName: 'doubler',
          inputMappings: [{ inputName: 'x', topic: '/in' }],
          outputMappings: [{ outputName: 'out', topic: '/info/x' }],
        },
        { processingModuleName: 'unknown' },
      ],
    });
    expect(problems.map(({ code }) => code)).toEqual(
      expect.arrayContaining([
        'syntax',
        'unknown_input',
        'forbidden_topic',
        'mapping_without_module',
      ]),
    );
    const syntax = problems.find(({ code }) => code === 'syntax');
    expect(syntax).toMatchObject({ moduleName: 'doubler', line: expect.any(Number) });
  });

  it('is only warned of what is doubtful [SE-5]', async () => {
    const world = await SessionWorld.create();
    const { extension } = await world.ask(TOPICS.add, {
      processingModules: [doubler, { ...doubler, name: 'other' }],
      ioMappings: [
        {
          processingModuleName: 'doubler',
          inputMappings: [{ inputName: 'in', topic: '/not/yet' }],
          outputMappings: [{ outputName: 'out', topic: '/same' }],
        },
        { processingModuleName: 'other', outputMappings: [{ outputName: 'out', topic: '/same' }] },
      ],
    });
    expect(extension?.problems.map(({ code, isError }) => [code, isError])).toEqual([
      ['topic_without_record', false],
      ['topic_written_twice', false],
    ]);
  });

  it('is warned of a cycle with a delay in it, but not of outputs without a receiver [SE-5]', async () => {
    const world = await SessionWorld.create();
    const slow = { triggerOnInput: { minDelayMs: 10 } };
    const { extension } = await world.ask(TOPICS.add, {
      processingModules: [
        { ...doubler, processingMode: slow },
        { ...doubler, name: 'silent' },
      ],
      ioMappings: [
        {
          processingModuleName: 'doubler',
          inputMappings: [{ inputName: 'in', topic: '/a' }],
          outputMappings: [{ outputName: 'out', topic: '/a' }],
        },
      ],
    });
    expect(extension?.problems.map(({ code }) => code)).toEqual(['cycle']);
  });

  it('is told of a component that gives another format [SE-4] [SE-5]', async () => {
    const world = await SessionWorld.create();
    const { device } = await world.master.call({
      topic: '/services/device/registration',
      device: {
        clientId: world.ada.id,
        name: 'mouse',
        components: [{ name: 'position', topic: '/in', messageFormat: 'vector2' }],
      },
    });
    const { problems } = await world.refusal(TOPICS.add, doubling('/in', '/out'));
    expect(problems[0]).toMatchObject({
      code: 'format_mismatch',
      path: 'ioMappings[0].inputMappings[0].topic',
      message: expect.stringContaining('vector2'),
    });
    await world.master.call({ topic: '/services/device/deregistration', device: device! });
    world.ada.publish('/in', 'vector2', { x: 1, y: 2 });
    const { extension } = await world.ask(TOPICS.add, doubling('/in', '/out'));
    expect(codes(extension?.problems)).toEqual(['topic_of_other_format']);
  });

  it('keeps its problems up to date while it runs [SE-5]', async () => {
    const world = await SessionWorld.create();
    const session = await world.ask(TOPICS.start, doubling('/in', '/out'));
    expect(session.extension?.problems).toMatchObject([{ code: 'topic_without_record' }]);
    world.ada.publish('/in', 'double', 1);
    await world.master.pass(1100);
    expect((await world.get(session)).extension?.problems).toEqual([]);
    expect(world.takeNews().at(-1)).toMatchObject(['change', { extension: { problems: [] } }]);
  });

  it('name the client whose topic it is, not its id [SE-5]', async () => {
    const world = await SessionWorld.create();
    const session = await world.ask(TOPICS.add, doubling(`/${world.ada.id}/arm/angle`, '/out'));
    expect(session.extension?.problems[0]?.message).toBe(
      'Topic "arm/angle" of the client "ada" has no value, so the input "in" is empty until one is published.',
    );
  });

  it('say that the client of a topic has left, which no list names any more [SE-5]', async () => {
    const world = await SessionWorld.create();
    const gone = 'b0c47f3b-1111-4222-8333-444455556666';
    const session = await world.ask(TOPICS.add, doubling(`/${gone}/arm/angle`, '/out'));
    expect(session.extension?.problems[0]?.message).toBe(
      'Topic "arm/angle" of a client that has left has no value, so the input "in" is empty until one is published.',
    );
  });

  it('reads what old clients send with tolerance [SE-6] [EC-22] [EC-23]', async () => {
    const world = await SessionWorld.create();
    const { session, error } = await world.master.callJson({
      topic: TOPICS.start,
      session: {
        name: 'old',
        processingModules: [
          null,
          {
            ...doubler,
            language: 0,
            status: 0,
            inputs: [
              { internalName: 'in', messageFormat: 'ubii.dataStructure.Nonsense' },
              { internalName: 'is it on?', messageFormat: 'boolean' },
            ],
          },
        ],
        ioMappings: [
          {
            processingModuleName: 'doubler',
            inputMappings: [
              { inputName: 'in', topicSource: '/old/in' },
              { inputName: 'is it on?', topicSource: 'a topic of old' },
            ],
            outputMappings: [{ outputName: 'out', topicDestination: '/old/out' }],
          },
        ],
        helper: 'field',
      },
    });
    expect(error).toBeUndefined();
    expect(session?.ioMappings[0]).toMatchObject({
      inputMappings: [{ topic: '/old/in' }, { topic: 'a topic of old' }],
      outputMappings: [{ topic: '/old/out' }],
    });
    await world.master.pass();
    world.ada.publish('/old/in', 'double', 1);
    await world.master.pass(10);
    expect(await world.value('/old/out')).toBe(2);
  });

  it('may not be too large [SE-7] [PM-57]', async () => {
    const world = await SessionWorld.create({
      limits: { sessions: 2, modulesPerSession: 2, mappingsPerSession: 3 },
    });
    const many = { processingModules: [doubler, doubler, doubler] };
    expect(await world.refusal(TOPICS.add, many)).toMatchObject({ code: 'resource_exhausted' });
    const mappings = {
      processingModules: [doubler],
      ioMappings: [{ inputMappings: Array.from({ length: 4 }, () => ({ inputName: 'in' })) }],
    };
    expect(await world.refusal(TOPICS.add, mappings)).toMatchObject({ code: 'resource_exhausted' });
    const tenMegabytes = withModule({
      onProcessingStringified: `() => {/*${'x'.repeat(10 << 20)}*/}`,
    });
    expect(await world.refusal(TOPICS.add, tenMegabytes)).toMatchObject({
      code: 'resource_exhausted',
      message: expect.stringContaining('moduleSourceBytes'),
    });
    const editorJson = JSON.stringify('x'.repeat(9 << 20));
    const bulky = { ...doubling('/in', '/out'), extension: { editorJson } };
    for (const topic of [TOPICS.add, TOPICS.save]) {
      expect(await world.refusal(topic, bulky)).toMatchObject({
        code: 'resource_exhausted',
        message: expect.stringContaining('sessionBytes'),
      });
    }
    await world.ask(TOPICS.add, doubling('/a', '/b'));
    await world.ask(TOPICS.add, doubling('/a', '/b'));
    expect(await world.refusal(TOPICS.add, doubling('/a', '/b'))).toMatchObject({
      code: 'resource_exhausted',
    });
  });

  it('has an id of a module only when no other session uses it [SE-1]', async () => {
    const world = await SessionWorld.create();
    const id = '11111111-1111-4111-8111-111111111111';
    const one = await world.ask(TOPICS.add, withModule({ id }));
    expect(one.processingModules[0]?.id).toBe(id);
    const other = await world.ask(TOPICS.add, withModule({ id }));
    expect(other.processingModules[0]?.id).not.toBe(id);
    expect(other.ioMappings[0]?.processingModuleId).toBe(other.processingModules[0]?.id);
  });
});
