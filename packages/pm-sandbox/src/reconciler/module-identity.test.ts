import { decode, encode, type Init, type ProcessingModule } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { hasSameCode, identityChanges, moduleIdentity } from './module-identity.ts';

const FORMAT = 'ubii.processing.ProcessingModule';

const FULL: Init<ProcessingModule> = {
  id: 'm1',
  name: 'mirror',
  sessionId: 's1',
  nodeId: 'n1',
  inputs: [{ internalName: 'in', messageFormat: 'double', choices: ['a', 'b'] }],
  outputs: [{ internalName: 'out', messageFormat: 'double' }],
  processingMode: { frequency: { hertz: 10 } },
  onProcessingStringified: '() => {}',
  extension: { libraries: ['http'], assets: ['pose'], optionalAssets: ['hands'] },
};

const moduleOf = (change: Init<ProcessingModule>): ProcessingModule =>
  decode(FORMAT, encode(FORMAT, { ...FULL, ...change }));

const changesOf = (change: Init<ProcessingModule>): string[] =>
  identityChanges(
    moduleIdentity({ module: moduleOf({}), isTrusted: false }),
    moduleIdentity({ module: moduleOf(change), isTrusted: false }),
  );

describe('moduleIdentity()', () => {
  it.each<[string, Init<ProcessingModule>]>([
    ['name', { name: 'other' }],
    ['sessionId', { sessionId: 's2' }],
    ['language', { language: 2 }],
    ['onCreatedStringified', { onCreatedStringified: '() => 1' }],
    ['onProcessingStringified', { onProcessingStringified: '() => 1' }],
    ['onHaltedStringified', { onHaltedStringified: '() => 1' }],
    ['onDestroyedStringified', { onDestroyedStringified: '() => 1' }],
    ['inputs', { inputs: [{ internalName: 'in', messageFormat: 'bool' }] }],
    ['outputs', { outputs: [] }],
    ['libraries', { extension: { ...FULL.extension, libraries: [] } }],
    ['assets', { extension: { ...FULL.extension, assets: ['pose', 'face'] } }],
    ['optionalAssets', { extension: { ...FULL.extension, optionalAssets: [] } }],
  ])('differs by %s [SE-15]', (field, change) => {
    expect(changesOf(change)).toEqual([field]);
  });

  it('differs by trust, as other engines run what is not trusted [PM-51]', () => {
    const module = moduleOf({});
    const [ours, others] = [true, false].map((isTrusted) => moduleIdentity({ module, isTrusted }));
    expect(identityChanges(ours!, others!)).toEqual(['isTrusted']);
  });

  it.each<[string, Init<ProcessingModule>]>([
    ['mode', { processingMode: { free: {} } }],
    ['node', { nodeId: 'n2' }],
    ['status', { status: 2 }],
    ['texts for people', { description: 'Better', tags: ['x'], authors: ['Ada'] }],
    [
      'notes of the master',
      {
        extension: {
          ...FULL.extension,
          version: '1.0.0',
          replaceable: true,
          origin: 1,
          grantIds: ['g'],
        },
      },
    ],
  ])('is the same with another %s [SE-15]', (_what, change) => {
    expect(changesOf(change)).toEqual([]);
  });

  it('does not tell an empty extension from none', () => {
    const bare = moduleIdentity({ module: moduleOf({ extension: undefined }), isTrusted: false });
    const empty = moduleIdentity({ module: moduleOf({ extension: {} }), isTrusted: false });
    expect(identityChanges(bare, empty)).toEqual([]);
  });

  it('does not depend on the order in which members were set', () => {
    const module = moduleOf({});
    const inputs = module.inputs.map(
      (input) => Object.fromEntries(Object.entries(input).reverse()) as unknown as typeof input,
    );
    const turned = moduleIdentity({ module: { ...module, inputs }, isTrusted: false });
    expect(identityChanges(moduleIdentity({ module, isTrusted: false }), turned)).toEqual([]);
  });
});

it('hasSameCode() compares the callbacks alone', () => {
  expect(hasSameCode(moduleOf({}), moduleOf({ name: 'other', inputs: [] }))).toBe(true);
  expect(hasSameCode(moduleOf({}), moduleOf({ onHaltedStringified: '() => 1' }))).toBe(false);
});
