import { ConnectionError } from '@ubii/client-web';
import { fromJson, SERVICES, ServiceError, type JoinCheck } from '@ubii/proto';

const TIMEOUT_MS = 8000;

/**
 * Checks a token or code over HTTP, without being a client: strangers have no connection. [AC-16]
 * @throws {ServiceError} error of the master
 * @throws {ConnectionError} if there is no reply
 */
export async function checkToken(token: string): Promise<JoinCheck> {
  let json: unknown;
  try {
    const response = await fetch('/services/json', {
      method: 'POST',
      headers: { 'Content-Type': 'application/json' },
      body: JSON.stringify({ topic: SERVICES.joinCheck.topic, joinCheckRequest: { token } }),
      signal: AbortSignal.timeout(TIMEOUT_MS),
    });
    json = await response.json();
  } catch (cause) {
    throw new ConnectionError('refused', 'The host does not answer', { cause });
  }
  const reply = fromJson('ubii.services.ServiceReply', json);
  if (reply.error !== undefined) throw ServiceError.fromWire(reply.error);
  if (reply.joinCheck === undefined) {
    throw new ConnectionError('protocol', 'This host does not support joining');
  }
  return reply.joinCheck;
}
