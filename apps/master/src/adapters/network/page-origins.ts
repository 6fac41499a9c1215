/**
 * Origins of the addresses of masters, each once, of HTTPS also with HTTP, which a master has on the same port; what is
 * no web address is left out. [CU-90]
 */
export function originsOf(addresses: readonly string[]): string[] {
  const origins = new Set<string>();
  for (const address of addresses) {
    if (!URL.canParse(address)) continue;
    const { protocol, origin, hostname, port } = new URL(address);
    if (/^https?:$/.test(protocol)) origins.add(origin);
    if (protocol === 'https:') origins.add(`http://${hostname}:${port || '443'}`);
  }
  return [...origins];
}
