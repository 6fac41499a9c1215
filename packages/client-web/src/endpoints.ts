import type { ClientOptions } from './core/client/client-options.ts';

/** URLs of a master. */
export interface Endpoints {
  readonly servicesUrl: string;
  readonly topicDataUrl: string;
}

/**
 * The addresses the options mean.
 * @param defaultUrl origin of the page, if there is one
 * @throws {TypeError} if they name no master, or are no addresses
 */
export function resolveEndpoints(
  options: Pick<ClientOptions, 'url' | 'servicesUrl' | 'topicDataUrl'>,
  defaultUrl: string | undefined,
): Endpoints {
  const { url = defaultUrl, servicesUrl, topicDataUrl } = options;
  const services = endpoint(servicesUrl, url, '/services/binary', /^https?:$/);
  const topicData = endpoint(topicDataUrl, url, '/topicdata', /^(http|ws)s?:$/);
  return { servicesUrl: services.href, topicDataUrl: toWebSocket(topicData).href };
}

/** @param own URL of the endpoint, which otherwise is below that of the master */
function endpoint(
  own: string | undefined,
  master: string | undefined,
  path: string,
  protocol: RegExp,
): URL {
  const given = own ?? master;
  if (given === undefined) {
    throw new TypeError(
      'Expected "url", or both "servicesUrl" and "topicDataUrl", received neither',
    );
  }
  const url = parse(own ?? `${given.replace(/\/+$/, '')}${path}`);
  if (url !== undefined && protocol.test(url.protocol)) return url;
  throw new TypeError(
    `Expected an address that begins with http:// or https://, such as http://localhost:8080, received "${given}"`,
  );
}

/** `URL.canParse` is newer than some browsers. */
function parse(text: string): URL | undefined {
  try {
    return new URL(text);
  } catch {
    return undefined;
  }
}

function toWebSocket(url: URL): URL {
  if (url.protocol === 'http:') url.protocol = 'ws:';
  if (url.protocol === 'https:') url.protocol = 'wss:';
  return url;
}
