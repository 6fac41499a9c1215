import type { TestProject } from 'vitest/node';
import { CLIENT_KINDS, type ClientKind } from './client-kind.ts';
import { install, installPython, type Installation } from './install.ts';

declare module 'vitest' {
  interface ProvidedContext {
    installations: Record<ClientKind, Installation>;
    mcap: Installation;
  }
}

/** Installs the published clients, and the reader of recordings, before the tests. In CI all of them must be there. */
export async function setup(project: TestProject): Promise<void> {
  const installations = Object.fromEntries(
    await Promise.all(CLIENT_KINDS.map(async (kind) => [kind, await install(kind)] as const)),
  ) as Record<ClientKind, Installation>;
  const mcap = await installPython('mcap');
  for (const [kind, installation] of Object.entries({ ...installations, mcap })) {
    if (!('missing' in installation)) continue;
    const sentence = `The ${kind} client is not tested: ${installation.missing}.`;
    if (process.env['CI'] === 'true') throw new Error(sentence);
    console.warn(sentence);
  }
  project.provide('installations', installations);
  project.provide('mcap', mcap);
}
