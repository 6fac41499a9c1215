import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { decode, encode, toJson, type Init, type ProcessingModule } from '@ubii/proto';

/** A folder of modules as an operator vouches for. */
export interface ModuleFolder {
  readonly path: string;
  stop(): Promise<void>;
}

const MODULE = 'ubii.processing.ProcessingModule';

export async function writeModuleFolder(
  modules: readonly Init<ProcessingModule>[],
): Promise<ModuleFolder> {
  const path = await mkdtemp(join(tmpdir(), 'ubii-bench-modules-'));
  for (const module of modules) {
    const json = toJson(MODULE, decode(MODULE, encode(MODULE, module)));
    await writeFile(join(path, `${module.name}.pm`), JSON.stringify(json));
  }
  return { path, stop: () => rm(path, { recursive: true, force: true }) };
}
