import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import { fromJson, ServiceError, type Recording } from '@ubii/proto';
import { atMaster } from '../../connection/at-master.ts';
import { authorized } from '../files/readable-file.ts';

/**
 * Uploads a file as a recording of the master. [RC-41]
 *
 * @throws ServiceError when the master refuses it
 * @throws ConnectionError when there is no answer
 */
export async function uploadRecording(
  file: File,
  client: Pick<UbiiClient, 'authorization'> & Partial<Pick<UbiiClient, 'masterUrl'>>,
): Promise<Recording> {
  const name = file.name.replace(/\.mcap$/i, '');
  let json: unknown;
  let isTaken: boolean;
  try {
    const response = await fetch(atMaster(client, `/recordings?name=${encodeURIComponent(name)}`), {
      method: 'POST',
      headers: authorized(client.authorization, { 'content-type': 'application/octet-stream' }),
      body: file,
    });
    isTaken = response.ok;
    json = await response.json();
  } catch (cause) {
    throw new ConnectionError('refused', 'The master does not answer', { cause });
  }
  if (isTaken) return fromJson('ubii.extension.Recording', json);
  const { error } = fromJson('ubii.services.ServiceReply', json);
  throw error
    ? ServiceError.fromWire(error)
    : new ConnectionError('protocol', 'This master does not support uploads');
}
