// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/devices/transport/usb_models.h"

#include <algorithm>
#include <initializer_list>

namespace planewright {

namespace {

using Bytes = std::vector<std::uint8_t>;

std::uint8_t low(std::size_t value)
{
    return static_cast<std::uint8_t>(value & 0xFF);
}

std::uint8_t high(std::size_t value)
{
    return static_cast<std::uint8_t>(value >> 8 & 0xFF);
}

void add(Bytes& to, std::initializer_list<std::uint8_t> bytes)
{
    to.insert(to.end(), bytes);
}

void addEndpoint(Bytes& to, std::uint8_t address, std::uint8_t attributes, std::size_t packetSize)
{
    add(to, {7, 5, address, attributes, low(packetSize), high(packetSize), 1});
}

Bytes deviceDescriptor(std::uint8_t deviceClass, std::uint16_t vendor, std::uint16_t product, std::uint16_t version,
                       std::uint8_t serial)
{
    return {18,
            1,
            0x00,
            0x02,
            deviceClass,
            0,
            0,
            64,
            low(vendor),
            high(vendor),
            low(product),
            high(product),
            low(version),
            high(version),
            1,
            2,
            serial,
            1};
}

Bytes configurationHeader(std::uint8_t interfaces, std::size_t rest)
{
    const std::size_t total = 9 + rest;
    return {9, 2, low(total), high(total), interfaces, 1, 0, 0xC0, 50};
}

UsbModel ftdiModel(std::uint16_t product, std::uint16_t version, std::size_t packetSize)
{
    UsbModel model;
    model.device = deviceDescriptor(0, 0x0403, product, version, 3);
    model.configuration = configurationHeader(1, 9 + 7 + 7);
    add(model.configuration, {9, 4, 0, 0, 2, 0xFF, 0xFF, 0xFF, 2});
    addEndpoint(model.configuration, 0x81, 2, packetSize);
    addEndpoint(model.configuration, 0x02, 2, packetSize);
    model.strings = {{1, "FTDI"}, {2, "USB Serial Converter"}, {3, "A9005a9b"}};
    model.packetSize = packetSize;
    model.drivers = {"ftdi_sio"};
    return model;
}

}  // namespace

UsbModel cdcModel(const CdcVariant& variant)
{
    UsbModel model;
    model.device = deviceDescriptor(2, variant.vendor, variant.product, 0x0100, 0);
    Bytes rest;
    add(rest, {9, 4, variant.controlInterface, 0, 1, 2, variant.subclass, 1, 0});
    add(rest, {5, 0x24, 0x00, 0x10, 0x01});                   // header: CDC 1.10
    add(rest, {5, 0x24, 0x01, 0x00, variant.dataInterface});  // call management
    add(rest, {4, 0x24, 0x02, 0x02});                         // line coding and control lines
    if (variant.unitedWith)
        add(rest, {5, 0x24, 0x06, variant.controlInterface, *variant.unitedWith});
    addEndpoint(rest, 0x83, 3, 16);
    add(rest, {9, 4, variant.dataInterface, 0, 2, 10, 0, 0, 0});
    addEndpoint(rest, variant.in, 2, variant.packetSize);
    addEndpoint(rest, variant.out, 2, variant.packetSize);
    model.configuration = configurationHeader(2, rest.size());
    model.configuration.insert(model.configuration.end(), rest.begin(), rest.end());
    model.strings = {{1, "Hokuyo Automatic Co, Ltd."}, {2, "URG-Series USB Driver"}};
    model.packetSize = variant.packetSize;
    model.in = variant.in;
    model.out = variant.out;
    model.drivers.resize(std::size_t{std::max(variant.controlInterface, variant.dataInterface)} + 1, "cdc_acm");
    return model;
}

UsbModel ft232rModel()
{
    return ftdiModel(0x6001, 0x0600, 64);
}

UsbModel ft232hModel()
{
    UsbModel model = ftdiModel(0x6014, 0x0900, 512);
    model.speed = "480";
    return model;
}

}  // namespace planewright
