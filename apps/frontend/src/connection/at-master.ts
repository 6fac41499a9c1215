import type { UbiiClient } from '@ubii/client-web';

/** URL of a path of the master that the page is connected to, which may not be the one that it was loaded from. [CU-92] */
export function atMaster({ masterUrl }: Partial<Pick<UbiiClient, 'masterUrl'>>, path: string) {
  return masterUrl === undefined || masterUrl === location.origin ? path : `${masterUrl}${path}`;
}
