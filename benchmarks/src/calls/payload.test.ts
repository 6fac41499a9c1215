import { createInlineSandboxes } from '@ubii/pm-sandbox/testing';
import { DEFAULT_RUNTIME_LIMITS } from '@ubii/pm-sandbox';
import { describe, expect, it } from 'vitest';
import { picturePayload, RECORD_PAYLOAD } from './payload.ts';

describe.each([RECORD_PAYLOAD, picturePayload()])('$title', (payload) => {
  it('is told from another call by what the module puts out', async () => {
    const sandbox = createInlineSandboxes().open(
      {
        instanceId: 'one',
        moduleName: 'one',
        source: { onProcessing: payload.onProcessing },
        isTrusted: true,
        libraries: [],
        assets: [],
        owner: '',
        inputs: ['in'],
        outputs: [{ name: 'out', format: payload.outputFormat }],
        limits: DEFAULT_RUNTIME_LIMITS,
      },
      { onLog: () => undefined, onKilled: () => undefined },
    );
    await sandbox.create();
    const inputs = [{ name: 'in', record: { bytes: payload.record(0x123456) } }];
    const { outputs } = await sandbox.run({ deltaTimeMs: 0, inputs });
    const [output] = outputs;
    if (output === undefined || !('value' in output)) throw new Error('expected one value');
    expect(payload.isOutput(output.value.bytes, 0x123456)).toBe(true);
    expect(payload.isOutput(output.value.bytes, 0x123457)).toBe(false);
  });
});
