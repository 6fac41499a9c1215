import type { ModuleFault, SandboxFactory } from '@ubii/pm-sandbox';
import { createInlineSandboxes } from '@ubii/pm-sandbox/testing';
import { decode, type ProcessingModule } from '@ubii/proto';
import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import type { DraftModule } from '../complete-modules.ts';
import { checkSources } from './check-sources.ts';

const TIMEOUT_MS = 1_000;

function draftOf(onProcessingStringified: string): DraftModule {
  const spec: ProcessingModule = {
    ...decode('ubii.processing.ProcessingModule', new Uint8Array()),
    name: 'm',
    onProcessingStringified,
  };
  return { spec, path: 'processingModules[0]', isLibraryCode: false } as DraftModule;
}

function sandboxesThat(check: SandboxFactory['check']): SandboxFactory {
  return { ...createInlineSandboxes(), check };
}

describe('the check of sources', () => {
  it('names what does not parse [SE-4]', async () => {
    const problems = await checkSources([draftOf('() => {')], {
      sandboxes: createInlineSandboxes(),
      clock: new FakeClock(),
      timeoutMs: TIMEOUT_MS,
    });
    expect(problems).toMatchObject([{ isError: true, code: 'syntax' }]);
  });

  it.each<ModuleFault>([
    { kind: 'crashed', phase: '', message: 'The worker does not answer.' },
    { kind: 'timeout', phase: '', message: 'Reading took too long.' },
  ])('does not blame the code when a worker fails ($kind)', async (fault) => {
    const problems = await checkSources([draftOf('() => ({})')], {
      sandboxes: sandboxesThat(() => Promise.resolve(fault)),
      clock: new FakeClock(),
      timeoutMs: TIMEOUT_MS,
    });
    expect(problems).toMatchObject([{ isError: false, code: 'not_checked' }]);
  });

  it('waits no longer than it may', async () => {
    const clock = new FakeClock();
    const checked = checkSources([draftOf('() => ({})')], {
      sandboxes: sandboxesThat(() => new Promise(() => {})),
      clock,
      timeoutMs: TIMEOUT_MS,
    });
    clock.advanceSync(TIMEOUT_MS);
    expect(await checked).toMatchObject([{ isError: false, code: 'not_checked' }]);
  });
});
