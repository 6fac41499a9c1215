import { ServiceError, SERVICES, type ServiceName } from '@ubii/proto';
import { expect, it } from 'vitest';
import { createCallHistory, errorOutcome, MAX_CALLS, replyOutcome } from './call-history.ts';
import { checkRequest, newRequest, requestType } from './request-json.ts';

it('the newest calls are kept', () => {
  const history = createCallHistory();
  const outcome = errorOutcome(new ServiceError('not_found', 'There is no such client.'));
  for (let atMs = 0; atMs < MAX_CALLS + 3; atMs++) {
    history.add({ service: 'clientGetList', request: undefined, atMs, tookMs: 1, outcome });
  }
  expect(history.calls.value).toHaveLength(MAX_CALLS);
  expect(history.calls.value[0]!.atMs).toBe(MAX_CALLS + 2);
  expect(outcome).toEqual({
    kind: 'error',
    code: 'not_found',
    sentence: 'There is no such client.',
  });
});

it('a reply is shown as the protocol writes it', () => {
  const outcome = replyOutcome('topicList', { elements: ['/a'] });
  expect(outcome).toEqual({ kind: 'reply', json: { elements: ['/a'] } });
});

it.each(Object.keys(SERVICES) as ServiceName[])(
  '%s begins with a request that can be read',
  (service) => {
    const type = requestType(service);
    if (type === undefined) return;
    expect(checkRequest(service, newRequest(service, 'id-1'))).toEqual([]);
    expect(checkRequest(service, { nothing: 1 })[0]!.path).toBe('nothing');
  },
);
