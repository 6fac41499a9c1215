// @vitest-environment happy-dom
import { ServiceError, type RecordingMarker } from '@ubii/proto';
import { describe, expect, it, vi } from 'vitest';
import { createToasts } from '../../ui/toasts/toasts.ts';
import { markNow } from './mark-now.ts';
import MarkedToast from './MarkedToast.vue';

const MARKER = { id: 'm1', text: '', timeMs: 5 } as RecordingMarker;

describe('markNow()', () => {
  it('marks this moment in all that is recorded, and offers the text to be edited', async () => {
    const toasts = createToasts();
    const call = vi.fn().mockResolvedValue(MARKER);
    await markNow({ client: { call, id: 'page' }, toasts });
    expect(call).toHaveBeenCalledWith('recordingMark', { clientId: 'page' });
    expect(toasts.list.value).toMatchObject([
      { body: { component: MarkedToast, props: { marker: MARKER } } },
    ]);
  });

  it('says why nothing was marked', async () => {
    const toasts = createToasts();
    const call = vi.fn().mockRejectedValue(new ServiceError('failed_precondition', 'All is off.'));
    await markNow({ client: { call, id: 'page' }, toasts });
    expect(toasts.list.value).toMatchObject([{ text: 'Not marked. All is off.' }]);
  });
});
