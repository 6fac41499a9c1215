import {
  fromJson,
  decode,
  encode,
  ModuleOrigin,
  ProcessingModuleLanguage,
  type Init,
  type ProcessingModule,
  type Session,
} from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { SequentialIds } from '../../testing/index.ts';
import { completeModules, type CompletionContext } from './complete-modules.ts';

const UUID = '11111111-1111-4111-8111-111111111111';

function sessionOf(init: Init<Session>): Session {
  return decode('ubii.sessions.Session', encode('ubii.sessions.Session', init));
}

function moduleOf(init: Init<ProcessingModule>): ProcessingModule {
  const format = 'ubii.processing.ProcessingModule';
  return decode(format, encode(format, init));
}

function complete(init: Init<Session>, context: Partial<CompletionContext> = {}) {
  const ids = new SequentialIds();
  return completeModules(sessionOf(init), {
    uuid: () => ids.uuid(),
    isTaken: () => false,
    nodeId: (text) => text || undefined,
    stored: () => undefined,
    offered: () => undefined,
    ...context,
  });
}

const code = {
  name: 'm',
  onProcessingStringified: '() => 1',
  onCreatedStringified: '() => 2',
  description: 'stored',
  inputs: [{ internalName: 'in', messageFormat: 'double' }],
  processingMode: { free: {} },
};

function extensionOf(origin: ModuleOrigin) {
  return { ...moduleOf({ name: 'm', extension: {} }).extension!, origin };
}

describe('a module of a session', () => {
  it('keeps an id that is an unused UUID, and otherwise gets a new one [SE-1]', () => {
    const { modules } = complete({
      processingModules: [{ id: UUID }, { id: UUID }, { id: 'mine' }, {}],
    });
    const ids = modules.map(({ spec }) => spec.id);
    expect(ids[0]).toBe(UUID);
    expect(new Set(ids).size).toBe(4);
    const taken = complete({ processingModules: [{ id: UUID }] }, { isTaken: () => true });
    expect(taken.modules[0]?.spec.id).not.toBe(UUID);
  });

  it.each([
    ['none of its own', {}, ModuleOrigin.MODULE_ORIGIN_BUILT_IN],
    ['that of the library', code, ModuleOrigin.MODULE_ORIGIN_BUILT_IN],
    ['other code', { onProcessingStringified: '() => 3' }, ModuleOrigin.MODULE_ORIGIN_UNKNOWN],
    ['another start', { ...code, onCreatedStringified: '' }, ModuleOrigin.MODULE_ORIGIN_UNKNOWN],
  ])('with %s has the origin of its code, whatever it says [SE-22]', (_, own, origin) => {
    const module = { ...moduleOf(code), extension: extensionOf(1) };
    const stored = () => ({ module, isTrusted: true });
    for (const extension of [undefined, extensionOf(1), extensionOf(2)]) {
      const given = { name: 'm', ...own, ...(extension && { extension }) };
      const [draft] = complete({ processingModules: [given] }, { stored }).modules;
      expect(draft?.spec.extension?.origin ?? 0).toBe(origin);
      expect(draft?.isLibraryCode).toBe(origin !== 0);
    }
  });

  it('has the origin of a stored module, or of a node that offers it, with their code alone [SE-22]', () => {
    const stored = () => ({ module: moduleOf(code), isTrusted: false });
    const offered = () => moduleOf({ name: 'm' });
    const originOf = (given: Init<ProcessingModule>, context: Partial<CompletionContext>) =>
      complete({ processingModules: [given] }, context).modules[0]?.spec.extension?.origin ?? 0;
    expect(originOf({ name: 'm' }, { stored })).toBe(ModuleOrigin.MODULE_ORIGIN_STORED);
    expect(originOf({ name: 'm' }, { offered })).toBe(ModuleOrigin.MODULE_ORIGIN_NODE);
    const other = { name: 'm', onProcessingStringified: '() => 3' };
    expect(originOf(other, { stored, offered })).toBe(0);
  });

  it('has the defaults of its inputs from the library [PM-5]', () => {
    const offered = fromJson('ubii.processing.ProcessingModule', {
      name: 'm',
      inputs: [
        { internalName: 'a', messageFormat: 'double', defaultJson: '{"double":1}' },
        { internalName: 'b', messageFormat: 'double', defaultJson: '{"double":2}' },
      ],
    });
    const stored = () => ({ module: offered, isTrusted: true });
    const inputs = [
      { internalName: 'a', messageFormat: 'double' },
      { internalName: 'b', messageFormat: 'bool' },
      { internalName: 'c', messageFormat: 'double' },
    ];
    const [draft] = complete({ processingModules: [{ name: 'm', inputs }] }, { stored }).modules;
    expect(draft?.spec.inputs.map(({ defaultJson }) => defaultJson)).toEqual([
      '{"double":1}',
      '',
      '',
    ]);
  });

  it('has the descriptions and choices of the library, unless it says its own [PM-6] [PM-7]', () => {
    const io = { messageFormat: 'string', description: 'What computes.' };
    const offered = fromJson('ubii.processing.ProcessingModule', {
      name: 'm',
      inputs: ['a', 'b', 'c'].map((internalName) => ({
        ...io,
        internalName,
        choices: ['auto', 'cpu'],
      })),
      outputs: [{ ...io, internalName: 'a' }],
    });
    const stored = () => ({ module: offered, isTrusted: true });
    const given = {
      name: 'm',
      inputs: [
        { internalName: 'a', messageFormat: 'string' },
        { internalName: 'b', messageFormat: 'string', description: 'Mine.', choices: ['gpu'] },
        { internalName: 'c', messageFormat: 'double' },
      ],
      outputs: [{ internalName: 'a', messageFormat: 'string' }],
    };
    const [draft] = complete({ processingModules: [given] }, { stored }).modules;
    const told = draft?.spec.inputs.map(({ description, choices }) => [description, choices]);
    expect(told).toEqual([
      ['What computes.', ['auto', 'cpu']],
      ['Mine.', ['gpu']],
      ['', []],
    ]);
    expect(draft?.spec.outputs[0]?.description).toBe('What computes.');
  });

  it('is completed from the library, its callbacks together [SE-1]', () => {
    const stored = () => ({ module: moduleOf(code), isTrusted: true });
    const given = { name: 'm', description: 'mine', onHaltedStringified: '() => 3' };
    const [draft] = complete({ processingModules: [given] }, { stored }).modules;
    expect(draft?.spec).toMatchObject({ ...code, description: 'mine', onHaltedStringified: '' });
    expect(draft?.isLibraryCode).toBe(true);
    const own = { ...given, onProcessingStringified: '() => 4' };
    const [other] = complete({ processingModules: [own] }, { stored }).modules;
    expect(other?.spec).toMatchObject({ onCreatedStringified: '', onHaltedStringified: '() => 3' });
    expect(other?.isLibraryCode).toBe(false);
  });

  it('is trusted only with the code of the operator, to the letter [PM-51] [PM-64]', () => {
    const stored = (isTrusted: boolean) => () => ({ module: moduleOf(code), isTrusted });
    const drafts = [
      complete({ processingModules: [code] }, { stored: stored(true) }),
      complete({ processingModules: [code] }, { stored: stored(false) }),
      complete(
        { processingModules: [{ ...code, onDestroyedStringified: '() => 5' }] },
        { stored: stored(true) },
      ),
    ];
    expect(drafts.map(({ modules }) => modules[0]?.isLibraryCode)).toEqual([true, false, false]);
  });

  it('is completed from its node first, when it has one [SE-1]', () => {
    const context = {
      stored: () => ({ module: moduleOf({ ...code, description: 'stored' }), isTrusted: true }),
      offered: () => moduleOf({ name: 'm', description: 'offered' }),
    };
    const describe = (nodeId: string) =>
      complete({ processingModules: [{ name: 'm', nodeId }] }, context).modules[0]?.spec
        .description;
    expect([describe(''), describe('node')]).toEqual(['stored', 'offered']);
  });

  it('has the language it is given, where 0 is none [SE-2]', () => {
    const offered = () => moduleOf({ name: 'm', language: ProcessingModuleLanguage.PY });
    const [draft] = complete(
      { processingModules: [{ name: 'm', language: 0 }] },
      { offered },
    ).modules;
    expect(draft?.spec.language).toBe(ProcessingModuleLanguage.PY);
  });
});

describe('a mapping', () => {
  it('goes to the module of its id, else to those of its name, in order [SE-2]', () => {
    const mapping = (topic: string, module: object) => ({
      ...module,
      inputMappings: [{ inputName: 'in', topic }],
    });
    const { modules, problems } = complete({
      processingModules: [{ name: 'm' }, { name: 'm', id: 'second' }, { name: 'm' }, { name: 'n' }],
      ioMappings: [
        mapping('/1', { processingModuleName: 'm' }),
        mapping('/2', { processingModuleId: 'second', processingModuleName: 'wrong' }),
        mapping('/3', { processingModuleName: 'm' }),
      ],
    });
    expect(problems).toEqual([]);
    expect(modules.map((draft) => draft.mapping.inputMappings[0]?.topic)).toEqual([
      '/1',
      '/2',
      '/3',
      undefined,
    ]);
    for (const { spec, mapping: own } of modules) {
      expect(own).toMatchObject({
        processingModuleId: spec.id,
        processingModuleName: spec.name,
      });
    }
    expect(modules.map(({ mappingPath }) => mappingPath).slice(0, 3)).toEqual([
      'ioMappings[0]',
      'ioMappings[1]',
      'ioMappings[2]',
    ]);
  });

  it('of a module that has one already is joined with it, or is a problem [SE-2] [SE-4]', () => {
    const one = complete({
      processingModules: [{ name: 'm' }],
      ioMappings: [
        { processingModuleName: 'm', inputMappings: [{ inputName: 'a' }] },
        { processingModuleName: 'm', inputMappings: [{ inputName: 'b' }] },
      ],
    });
    expect(one.modules[0]?.mapping.inputMappings.map(({ inputName }) => inputName)).toEqual([
      'a',
      'b',
    ]);
    const two = complete({
      processingModules: [{ name: 'm' }, { name: 'm' }],
      ioMappings: [1, 2, 3].map(() => ({ processingModuleName: 'm' })),
    });
    expect(two.problems).toMatchObject([
      { code: 'mapping_without_module', path: 'ioMappings[2]', isError: true },
    ]);
  });

  it('has ids for its muxers and demuxers [SE-2]', () => {
    const { modules } = complete({
      processingModules: [{ name: 'm' }],
      ioMappings: [
        {
          processingModuleName: 'm',
          inputMappings: [
            { inputName: 'a', topicMux: {} },
            { inputName: 'b', topicMux: { id: 'x' } },
          ],
          outputMappings: [{ outputName: 'c', topicDemux: {} }],
        },
      ],
    });
    const { inputMappings, outputMappings } = modules[0]!.mapping;
    expect(inputMappings[0]?.topicMux?.id).not.toBe('');
    expect(inputMappings[1]?.topicMux?.id).toBe('x');
    expect(outputMappings[0]?.topicDemux?.id).not.toBe('');
  });
});
