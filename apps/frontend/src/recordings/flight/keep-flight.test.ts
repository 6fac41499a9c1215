// @vitest-environment happy-dom
import { ServiceError, type Recording } from '@ubii/proto';
import { describe, expect, it, vi } from 'vitest';
import { createToasts } from '../../ui/toasts/toasts.ts';
import { keepFlight } from './keep-flight.ts';
import KeptToast from './KeptToast.vue';

const RECORDING = { id: 'r1', name: 'Kept 14:02', durationMs: 300_000 } as Recording;

describe('keepFlight()', () => {
  it('keeps the last minutes, and offers the name to be edited', async () => {
    const toasts = createToasts();
    const call = vi.fn().mockResolvedValue(RECORDING);
    await keepFlight({ client: { call, id: 'page' }, toasts });
    expect(call).toHaveBeenCalledWith('flightRecorderKeep', { clientId: 'page' });
    expect(toasts.list.value).toMatchObject([
      { body: { component: KeptToast, props: { recording: RECORDING } } },
    ]);
  });

  it('says why nothing was kept', async () => {
    const toasts = createToasts();
    const call = vi.fn().mockRejectedValue(new ServiceError('failed_precondition', 'It is off.'));
    await keepFlight({ client: { call, id: 'page' }, toasts });
    expect(toasts.list.value).toMatchObject([{ text: 'Nothing was kept. It is off.' }]);
  });
});
