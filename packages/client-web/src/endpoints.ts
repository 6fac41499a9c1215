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
  return {
    servicesUrl: parse(servicesUrl ?? under(url, '/services/binary'), /^https?:$/).href,
    topicDataUrl: toWebSocket(parse(topicDataUrl ?? under(url, '/topicdata'), /^(http|ws)s?:$/))
      .href,
  };
}

function under(url: string | undefined, path: string): string {
  if (url === undefined) {
    throw new TypeError(
      'Expected "url", or both "servicesUrl" and "topicDataUrl", received neither',
    );
  }
  return `${url.replace(/\/+$/, '')}${path}`;
}

function parse(text: string, protocol: RegExp): URL {
  const url = URL.canParse(text) ? new URL(text) : undefined;
  if (url !== undefined && protocol.test(url.protocol)) return url;
  throw new TypeError(
    `The address of a master begins with http:// or https://, such as http://localhost:8080, received "${text}"`,
  );
}

function toWebSocket(url: URL): URL {
  if (url.protocol === 'http:') url.protocol = 'ws:';
  if (url.protocol === 'https:') url.protocol = 'wss:';
  return url;
}
