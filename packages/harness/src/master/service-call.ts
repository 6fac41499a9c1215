import { decode, encode, type Init, type ServiceReply, type ServiceRequest } from '@ubii/proto';

const CALL_TIMEOUT_MS = 20_000;

/**
 * Calls a service; an error is a reply as well.
 *
 * @param url address of the services as protobuf
 * @throws Error when there is no reply within 20 s
 */
export async function askService(
  url: string,
  request: Init<ServiceRequest>,
  bearer?: string,
): Promise<ServiceReply> {
  const response = await fetch(url, {
    method: 'POST',
    headers: {
      'content-type': 'application/octet-stream',
      ...(bearer === undefined ? {} : { authorization: `Bearer ${bearer}` }),
    },
    body: Buffer.from(encode('ubii.services.ServiceRequest', request)),
    signal: AbortSignal.timeout(CALL_TIMEOUT_MS),
  });
  return decode('ubii.services.ServiceReply', new Uint8Array(await response.arrayBuffer()));
}

/** Returns the reply. @throws Error with the master's sentence when the reply is an error */
export function expectReply(request: Init<ServiceRequest>, reply: ServiceReply): ServiceReply {
  if (reply.error === undefined) return reply;
  const { message, details } = reply.error as { message: string; details?: unknown };
  const more = details === undefined ? '' : ` ${JSON.stringify(details)}`;
  throw new Error(`${request.topic} was answered with: ${message}${more}`);
}

/** Reads the page `/metrics`. @returns values by their names with labels, as Prometheus writes them */
export async function readMetrics(url: string): Promise<ReadonlyMap<string, number>> {
  const response = await fetch(new URL('/metrics', url), {
    signal: AbortSignal.timeout(CALL_TIMEOUT_MS),
  });
  const text = await response.text();
  if (!response.ok) throw new Error(`/metrics was answered with ${response.status}: ${text}`);
  return parseMetrics(text);
}

/** Parses the text format of Prometheus. */
export function parseMetrics(text: string): ReadonlyMap<string, number> {
  return new Map(
    text
      .split('\n')
      .filter((line) => line !== '' && !line.startsWith('#'))
      .map((line) => {
        const at = line.lastIndexOf(' ');
        return [line.slice(0, at), Number(line.slice(at + 1))];
      }),
  );
}
