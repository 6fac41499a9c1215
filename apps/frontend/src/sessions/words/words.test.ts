import { fromJson, type NodeInfo } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { aSession } from '../testing/a-session.ts';
import { mappedModule } from './mapping-words.ts';
import { modeWords } from './mode-words.ts';
import { placeOf } from './problem-place.ts';
import { canRun, nodeHint, nodeName } from './node-words.ts';

const mode = (json: object) => fromJson('ubii.processing.ProcessingMode', json);

describe('modeWords', () => {
  it('says when a module runs [PM-20]', () => {
    expect(modeWords(undefined)).toBe('30 Hz');
    expect(modeWords(mode({ frequency: { hertz: 0 } }))).toBe('30 Hz');
    expect(modeWords(mode({ frequency: { hertz: 60 } }))).toBe('60 Hz');
    expect(modeWords(mode({ triggerOnInput: {} }))).toBe('on any input');
    expect(modeWords(mode({ triggerOnInput: { allInputsNeedUpdate: true, minDelayMs: 16 } }))).toBe(
      'on all inputs, 16 ms apart',
    );
    expect(modeWords(mode({ lockstep: {} }))).toBe('lockstep');
    expect(modeWords(mode({ free: {} }))).toBe('free');
  });
});

describe('mappedModule', () => {
  it('lists what is declared with what flows there, and then what is mapped without being declared', () => {
    const session = aSession();
    session.ioMappings[0]!.outputMappings.push(
      fromJson('ubii.sessions.TopicOutputMapping', { outputName: 'gone', topic: '/x' }),
    );
    const { inputs, outputs } = mappedModule(session.processingModules[0]!, session);
    expect(inputs.map(({ name, end }) => [name, end])).toEqual([
      ['position', { kind: 'topic', topic: '/a/position' }],
      ['mirrorX', { kind: 'constant', value: 'true' }],
      ['rest', { kind: 'none' }],
    ]);
    expect(outputs.map(({ name, isDeclared }) => [name, isDeclared])).toEqual([
      ['mirrored', true],
      ['gone', false],
    ]);
  });

  it('says which topics a muxer takes, and what tells them apart [PM-41, PM-43]', () => {
    const session = aSession();
    const [mapping] = session.ioMappings;
    const muxer = (json: object) => {
      mapping!.inputMappings = [
        fromJson('ubii.sessions.TopicInputMapping', { inputName: 'position', topicMux: json }),
      ];
      return mappedModule(session.processingModules[0]!, session).inputs[0]!.end;
    };
    expect(muxer({ topicGlob: '/*/touch', identitySource: 1 })).toEqual({
      kind: 'muxer',
      pattern: '/*/touch',
      words: 'identified by client',
    });
    expect(muxer({ topicSelector: '.*', identityMatchPattern: '[0-9]+' })).toMatchObject({
      pattern: '.*',
      words: 'identified by [0-9]+',
    });
    expect(muxer({ component: { messageFormat: 'vector2', tags: ['touch'] } })).toMatchObject({
      pattern: 'components: vector2, tagged touch',
    });
  });
});

describe('nodes', () => {
  const node = (json: object): NodeInfo => fromJson('ubii.extension.NodeInfo', json);
  const master = node({
    clientId: 'm',
    name: 'ubii',
    available: true,
    instances: 2,
    node: { kind: 'MASTER', runsJavascript: true },
  });

  it('have names people know', () => {
    const find = (id: string) => (id === 'm' ? master : undefined);
    expect(nodeName('m', find, 'self')).toBe('Master');
    expect(nodeName('self', find, 'self')).toBe('This tab');
    expect(nodeName('0123456789ab', find, 'self')).toBe('01234567…');
    expect(nodeName('', find, 'self')).toBe('none yet');
    expect(nodeHint(master)).toBe('master, 2 modules');
  });

  it('run what they have, or what comes with code [SE-30]', () => {
    const code = { name: 'x', onProcessingStringified: '() => 1' };
    expect(canRun(master, code)).toBe(true);
    expect(canRun(master, { name: 'x', onProcessingStringified: '' })).toBe(false);
    const python = node({ clientId: 'p', available: true, moduleNames: ['y'] });
    expect(canRun(python, code)).toBe(false);
    expect(canRun(python, { name: 'y', onProcessingStringified: '' })).toBe(true);
    expect(canRun({ ...master, available: false }, code)).toBe(false);
  });
});

describe('problems', () => {
  it('are found at the input or output they are about', () => {
    expect(placeOf(aSession(), 'ioMappings[0].outputMappings[0].topic')).toEqual({
      moduleId: 'module',
      side: 'output',
      name: 'mirrored',
    });
    expect(placeOf(aSession(), 'processingModules[0].inputs[2]')).toMatchObject({ name: 'rest' });
    expect(placeOf(aSession(), 'processingModules[0]')).toBeUndefined();
    expect(placeOf(aSession(), 'ioMappings[7].inputMappings[0]')).toBeUndefined();
  });
});
