export type NetworkKind = 'wifi' | 'ethernet' | 'virtual';

/** Properties of a network interface that the system reports besides its name. */
export interface InterfaceFacts {
  readonly isWireless: boolean;
  /** undefined where the system does not say. */
  readonly hasHardware: boolean | undefined;
}

/** Names of bridges, containers, virtual machines, tunnels and private networks. */
const VIRTUAL =
  /^(lo|docker|br-|bridge|veth|virbr|vmnet|vboxnet|vEthernet|utun|tun|tap|wg|tailscale|zt|ham|ppp|ipsec|awdl|llw|anpi|cni|flannel|cali|podman|lxc|lxd|dummy|bond|ifb)/i;

/** Names that Linux (`wlan0`, `wlp3s0`) and Windows (`Wi-Fi`, `WLAN`) give to Wi-Fi. */
const WIFI = /^(wl|wi-?fi|wlan|drahtlos|wireless)/i;

/** Kind of network that an interface belongs to, from its properties and its name. */
export function classifyInterface(name: string, facts: InterfaceFacts): NetworkKind {
  if (facts.isWireless || WIFI.test(name)) return 'wifi';
  if (VIRTUAL.test(name)) return 'virtual';
  // Inside a container `eth0` is one end of a virtual cable, and still the way in.
  if (facts.hasHardware === false && !/^(eth|en)/i.test(name)) return 'virtual';
  return 'ethernet';
}
