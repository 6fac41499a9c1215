import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createAssetStore, type AnyModuleDefinition } from '@ubii/pm-sandbox';
import { AssetFolders } from '@ubii/pm-sandbox/node';
import { createInlineSandboxes } from '@ubii/pm-sandbox/testing';
import { writeAssetSets } from '@ubii/vision/assets';
import { buildLibrary } from '@ubii/vision/library';
import { readPhoto } from '@ubii/vision/testing';
import type { DrivenModule } from './drive-module.ts';
import { driveIn } from './drive-sandboxed.ts';

let built: Promise<string> | undefined;

/** Builds the asset sets once for all tests of this process. @returns their folder */
function builtSets(): Promise<string> {
  built ??= (async () => {
    const folder = mkdtempSync(join(tmpdir(), 'ubii-vision-'));
    process.once('exit', () => rmSync(folder, { recursive: true, force: true }));
    const library = join(folder, 'vision.js');
    await buildLibrary(library);
    writeAssetSets(folder, library);
    return folder;
  })();
  return built;
}

/**
 * An instance of a module with its real asset sets, on the thread of the test.
 *
 * @param models folder of optional asset sets; default: there are none
 * @param log takes what the module writes to its console
 */
export async function driveWithVision(
  definition: AnyModuleDefinition,
  { models, log = [] }: { readonly models?: string; readonly log?: string[] } = {},
): Promise<DrivenModule> {
  const store = createAssetStore(new AssetFolders([await builtSets()]));
  const { signal } = new AbortController();
  const assets = await store.load(definition.assets ?? [], signal, () => undefined);
  const sandboxes = createInlineSandboxes({ nowMs: () => performance.now() });
  const optional = createAssetStore(new AssetFolders(models === undefined ? [] : [models]));
  return driveIn(() => sandboxes, true, assets, {
    onLog: ({ text }) => log.push(text),
    onLoadAssets: async (name) => (await optional.load([name], signal, () => undefined))[0]!,
  })(definition);
}

/** A photograph of `@ubii/vision` as the message `Image2D`. */
export function photoImage(file: string) {
  const { width, height, data } = readPhoto(file);
  return { width, height, dataFormat: 1, data: new Uint8Array(data) };
}
