import { existsSync, readdirSync, readFileSync } from 'node:fs';
import {
  moduleProblems,
  moduleToWire,
  parseModule,
  type AnyModuleDefinition,
  type IoInit,
} from '@ubii/pm-sandbox';
import { fromJson, parseDataFormat, toJson, type ProcessingModule } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { driveDirectly, formatOf, isList } from '../test/drive-module.ts';
import { freeNames } from '../test/free-names.ts';
import { expectKnownNames } from '../test/known-names.ts';
import { PLAIN_MODULES } from '../test/plain-modules.ts';
import { WAYS } from '../test/ways.ts';
import * as library from './index.ts';

const { MODULES, moduleLibrary } = library;
/** Checking types takes its time on a busy machine. */
const CHECK_TIMEOUT_MS = 30_000;
const FORMAT = 'ubii.processing.ProcessingModule';
const FOLDERS = readdirSync(import.meta.dirname, { withFileTypes: true })
  .filter((entry) => entry.isDirectory() && !['examples', 'generated'].includes(entry.name))
  .map(({ name }) => name)
  .sort();

function isDefinition(value: unknown): value is AnyModuleDefinition {
  return typeof value === 'object' && value !== null && 'onProcessing' in value;
}

describe('the library', () => {
  it('has every module that is exported, once, from a to z', () => {
    const names = MODULES.map(({ name }) => name);
    expect(names).toEqual([...new Set(names)].sort());
    expect(new Set(MODULES)).toEqual(new Set(Object.values(library).filter(isDefinition)));
  });

  it.each(MODULES.map((module) => [module.name, module] as const))(
    'has %s described, in the list of the library and in its own page',
    (name, module) => {
      expect(module).toMatchObject({ version: expect.stringMatching(/^\d+\.\d+\.\d+$/) });
      // Two lines of the palette, with the formats before it.
      expect(module.description, 'one sentence of 22 to 50 characters').toMatch(
        /^[A-Z].{20,48}\.$/,
      );
      expect(module.tags?.length).toBeGreaterThan(0);
      expect(readFileSync(`${import.meta.dirname}/../README.md`, 'utf8')).toContain(`\`${name}\``);
      // The longest that fits: `noise-gate` is not in the folder `noise`.
      const folder = FOLDERS.findLast((folder) => name.startsWith(folder))!;
      const page = readFileSync(`${import.meta.dirname}/${folder}/README.md`, 'utf8');
      expect(page).toContain(`\`${name}\``);
      for (const io of Object.keys({ ...module.inputs, ...module.outputs })) {
        expect(page, io).toContain(`\`${io}\``);
      }
    },
  );

  it('says of every input and output what its values mean, in one sentence [PM-6]', () => {
    for (const { name, inputs, outputs } of moduleLibrary()) {
      for (const { internalName, description } of [...inputs, ...outputs]) {
        expect(description, `${name}.${internalName}`).toMatch(/^[A-Z].{5,118}\.$/);
      }
    }
  });

  it('offers the words that inputs understand [PM-7]', () => {
    const choices = moduleLibrary().flatMap(({ name, inputs }) =>
      inputs
        .filter((input) => input.choices.length > 0)
        .map((input) => [`${name}.${input.internalName}`, input.choices] as const),
    );
    const backends = ['auto', 'webgpu', 'webgl', 'wasm', 'cpu'];
    expect(Object.fromEntries(choices)).toEqual({
      'body-pose.backend': backends,
      'camera-calibration.dictionary': expect.arrayContaining(['aruco_5x5_50']),
      'hand-pose.backend': backends,
      'image-tools.format': ['GRAY8', 'RGB8', 'RGBA8'],
      'marker-tracking.dictionary': expect.arrayContaining(['aruco_4x4_50', 'apriltag_36h11']),
      'object-detection.backend': backends,
      'object-detection.detector': ['centernet', 'coco-ssd'],
    });
  });

  it.each(FOLDERS)('has a page and tests in %s', (folder) => {
    expect(existsSync(`${import.meta.dirname}/${folder}/README.md`)).toBe(true);
    expect(existsSync(`${import.meta.dirname}/${folder}/${folder}.test.ts`)).toBe(true);
  });
});

describe('the pages of the library', () => {
  it.each(FOLDERS)('map what the module has, in the example of %s', (folder) => {
    const page = readFileSync(`${import.meta.dirname}/${folder}/README.md`, 'utf8');
    const [, json = ''] = /```json\n([^]*?)```/.exec(page) ?? [];
    expectKnownNames(fromJson('ubii.sessions.Session', JSON.parse(json)));
  });
});

/** Values for inputs without a default, another each time. */
function samples(module: AnyModuleDefinition, index: number): Record<string, unknown> {
  const number = [0.7, 0.2, 0.9, 0.4][index]!;
  const vector = { x: number, y: 1 - number, z: number / 2, w: 1 };
  const values: Readonly<Record<string, unknown>> = {
    double: number,
    int32: index,
    bool: index % 2 === 0,
    vector2: { x: vector.x, y: vector.y },
    vector3: { x: vector.x, y: vector.y, z: vector.z },
    vector4: vector,
    quaternion: vector,
  };
  return Object.fromEntries(
    Object.entries(module.inputs as Readonly<Record<string, IoInit>>).flatMap(([name, init]) => {
      const isSet = typeof init === 'object' && init.default !== undefined;
      const value = values[formatOf(init)];
      return isSet || isList(init) || value === undefined ? [] : [[name, value]];
    }),
  );
}

describe.each(MODULES.map((module) => [module.name, module] as const))('%s', (_name, module) => {
  it('is the same after a journey as JSON [PM-1] [PM-2]', () => {
    const wire = moduleToWire(module);
    const text = JSON.stringify(toJson(FORMAT, wire));
    const arrived = fromJson(FORMAT, JSON.parse(text));
    expect(moduleProblems(arrived)).toEqual([]);

    const parsed = parseModule(arrived);
    const ios = (inits: Readonly<Record<string, IoInit>>) =>
      Object.entries(inits).map(([name, init]) =>
        expect.objectContaining({ name, format: formatOf(init), isList: isList(init) }),
      );
    expect(parsed.name).toBe(module.name);
    expect(parsed.inputs).toEqual(ios(module.inputs));
    expect(parsed.outputs).toEqual(ios(module.outputs));
    expect(parsed.libraries).toEqual(module.libraries ?? []);
    expect(parsed.version).toBe(module.version);
    expect(parsed.source?.onProcessing).toBe(wire.onProcessingStringified);
    // The text of the library is made by another compiler than that of the tests.
    expect({ ...parsed, source: undefined }).toEqual({
      ...parseModule(libraryModule(module.name)),
      source: undefined,
    });
  });
});

describe.each(PLAIN_MODULES.map((module) => [module.name, module] as const))(
  '%s',
  (_name, module) => {
    it('names the defaults that its callback uses [PM-5]', async () => {
      const defaults = Object.entries(module.inputs as Readonly<Record<string, IoInit>>).flatMap(
        ([name, init]) =>
          typeof init === 'object' && init.default !== undefined ? [[name, init.default]] : [],
      );
      const http = { get: () => new Promise(() => {}) };
      const [bare, filled] = await Promise.all([1, 2].map(() => driveDirectly(module, { http })));
      for (const [index, deltaMs] of [0, 16, 40, 900].entries()) {
        const given = samples(module, index);
        const without = await bare!.run(deltaMs, given);
        const withDefaults = await filled!.run(deltaMs, {
          ...given,
          ...Object.fromEntries(defaults),
        });
        // Measured durations differ between runs.
        delete without['durationMs'];
        delete withDefaults['durationMs'];
        expect(withDefaults).toEqual(without);
      }
    });

    it.each(WAYS)('runs before anything came, %s', async (_way, drive) => {
      const driven = await drive(module, {
        http: { get: () => Promise.reject(new Error('none')) },
      });
      await driven.run(0);
      await driven.run(16);
      await driven.run(16, {}, []);
    });
  },
);

describe('the source texts of the library', () => {
  it(
    'see nothing outside of them but the language [PM-2]',
    () => {
      const sources = new Map<string, string>();
      for (const module of moduleLibrary()) {
        for (const [callback, text] of sourcesOf(module)) {
          sources.set(`${module.name}.${callback}`, text);
        }
      }
      expect(sources.size).toBeGreaterThanOrEqual(MODULES.length);
      const allowed = new Set(['console', 'performance']);
      for (const [source, names] of freeNames(sources)) {
        expect(
          [...names].filter((name) => !allowed.has(name)),
          source,
        ).toEqual([]);
      }
    },
    CHECK_TIMEOUT_MS,
  );

  it('would be caught with a variable from outside', () => {
    const source = '(a) => { if (a) return a + Math.PI; return outside + [1].at(-1); }';
    expect(freeNames(new Map([['fake.onProcessing', source]]))).toEqual(
      new Map([['fake.onProcessing', new Set(['outside'])]]),
    );
  });

  it('are small', () => {
    for (const module of moduleLibrary()) {
      const length = [...sourcesOf(module)].reduce((sum, [, text]) => sum + text.length, 0);
      expect(length, module.name).toBeLessThan(8_192);
    }
  });

  it('name formats that every node knows', () => {
    for (const { inputs, outputs } of moduleLibrary()) {
      for (const { messageFormat } of [...inputs, ...outputs]) {
        expect(parseDataFormat(messageFormat)).toBeDefined();
      }
    }
  });
});

function libraryModule(name: string): ProcessingModule {
  return moduleLibrary().find((module) => module.name === name)!;
}

function sourcesOf(module: ProcessingModule): [callback: string, text: string][] {
  const sources: [string, string][] = [
    ['onCreated', module.onCreatedStringified],
    ['onProcessing', module.onProcessingStringified],
    ['onHalted', module.onHaltedStringified],
    ['onDestroyed', module.onDestroyedStringified],
  ];
  return sources.filter(([, text]) => text !== '');
}
