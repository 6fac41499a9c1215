/** Origins of web addresses, each once; what is no web address is left out. */
export function originsOf(addresses: readonly string[]): string[] {
  const origins = new Set<string>();
  for (const address of addresses) {
    if (!URL.canParse(address)) continue;
    const { protocol, origin } = new URL(address);
    if (/^https?:$/.test(protocol)) origins.add(origin);
  }
  return [...origins];
}
